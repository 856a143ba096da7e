// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/mesh_arrays.h"

#include <cstddef>

#include "radcert/core/contract.h"
#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {

namespace {

std::string_view bytes_of(const void* first, std::size_t length) {
  return length == 0 ? std::string_view() : std::string_view(static_cast<const char*>(first), length);
}

std::string digest(const MeshArrays& arrays) {
  const std::string names = length_prefixed(arrays.groups);
  const EmbeddedFile parts[] = {
      {"points", bytes_of(arrays.coordinates.data(), arrays.coordinates.size_bytes())},
      {"triangles", bytes_of(arrays.triangles.data(), arrays.triangles.size_bytes())},
      {"groups", names}};
  return digest_of(parts);
}

}  // namespace

MeshFile mesh_of_arrays(const MeshArrays& arrays, const std::string& name) {
  constexpr std::size_t three = 3;
  constexpr int bits_of_double = 53;
  const std::size_t points = arrays.coordinates.size() / three;
  const std::size_t triangles = arrays.triangles.size() / three;
  expects(points * three == arrays.coordinates.size(), "three coordinates a point",
          named("count", arrays.coordinates.size()));
  expects(triangles * three == arrays.triangles.size(), "three corners a triangle",
          named("count", arrays.triangles.size()));
  expects(arrays.groups.empty() || arrays.groups.size() == triangles, "a group a triangle, or none",
          named("count", arrays.groups.size()));
  return with_source(name, [&] {
    MeshBuilder builder;
    for (std::size_t i = 0; i < points; ++i) {
      const std::string place = "point " + std::to_string(i);
      const double* at = arrays.coordinates.data() + three * i;
      builder.vertex({builder.coordinate(at[0], place), builder.coordinate(at[1], place),
                      builder.coordinate(at[2], place)});
    }
    for (std::size_t k = 0; k < triangles; ++k) {
      const std::string place = "triangle " + std::to_string(k);
      if (!arrays.groups.empty()) builder.group(arrays.groups[k]);
      for (std::size_t j = 0; j < three; ++j) {
        const std::int64_t corner = arrays.triangles[three * k + j];
        if (corner < 0)
          refuse_mesh(place, std::to_string(corner), "is no index, counted from 0, of a point",
                      "indices from 0 to " + std::to_string(points == 0 ? 0 : points - 1));
        builder.corner(static_cast<std::size_t>(corner));
      }
      builder.end_face(place);
    }
    MeshFile mesh = builder.finish("arrays", bits_of_double);
    mesh.digest = digest(arrays);
    return mesh;
  });
}

}  // namespace radcert
