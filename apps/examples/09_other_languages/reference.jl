# SPDX-License-Identifier: GPL-3.0-or-later
# Julia: a reference value with a proof, and the configuration factors of a tetrahedron. The structs are those of radcert.h.
const library = get(ENV, "RADCERT_C", "libradcert_c.so.1")

struct Failure
    status::Cint
    message::Cstring
end
last_words() = unsafe_string(unsafe_load(@ccall library.radcert_last_error()::Ptr{Failure}).message)
require(status) = status == 0 || error(last_words())

struct ReferenceValue
    name::Cstring
    midpoint::Cstring
    radius::Cstring
    lower::Cdouble
    upper::Cdouble
end

handle = Ref{Ptr{Cvoid}}(C_NULL)
require(@ccall library.radcert_reference_make("cube_opposite_faces"::Cstring, C_NULL::Ptr{Cvoid}, 0::Csize_t, 30::Int64,
                                              C_NULL::Ptr{Cvoid}, handle::Ptr{Ptr{Cvoid}})::Cint)
number = Ref{Ptr{ReferenceValue}}(C_NULL)
require(@ccall library.radcert_reference_read(handle[]::Ptr{Cvoid}, number::Ptr{Ptr{ReferenceValue}})::Cint)
value = unsafe_load(number[])
println(unsafe_string(value.midpoint), " +- ", unsafe_string(value.radius))
@ccall library.radcert_reference_free(handle[]::Ptr{Cvoid})::Cvoid

struct Mesh
    size::Csize_t
    points::Ptr{Cdouble}
    point_count::Csize_t
    triangles::Ptr{Int64}
    triangle_count::Csize_t
    groups::Ptr{Cstring}
    front::Cstring
    name::Cstring
end
struct FactorMatrix
    count::Csize_t
    names::Ptr{Cstring}
    value::Ptr{Cdouble}
    radius::Ptr{Cdouble}
end

points = Float64[0 1 0 0; 0 0 1 0; 0 0 0 1]              # a column a point
triangles = Int64[0 0 0 1; 1 2 3 3; 2 3 1 2]             # counted from 0
GC.@preserve points triangles begin
    mesh = Ref(Mesh(sizeof(Mesh), pointer(points), 4, pointer(triangles), 4, C_NULL, C_NULL, C_NULL))
    factors = Ref{Ptr{Cvoid}}(C_NULL)
    wish = C_NULL
    require(@ccall library.radcert_factors_make(mesh::Ptr{Mesh}, wish::Ptr{Cvoid}, C_NULL::Ptr{Cvoid},
                                                factors::Ptr{Ptr{Cvoid}})::Cint)
end
shown = Ref{Ptr{FactorMatrix}}(C_NULL)
require(@ccall library.radcert_factors_read(factors[]::Ptr{Cvoid}, shown::Ptr{Ptr{FactorMatrix}})::Cint)
matrix = unsafe_load(shown[])
n = Int(matrix.count)
println("one group sees itself: ", unsafe_wrap(Array, matrix.value, n * n)[1], " +- ",
        unsafe_wrap(Array, matrix.radius, n * n)[1])
@ccall library.radcert_factors_free(factors[]::Ptr{Cvoid})::Cvoid
