// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/formats/json/json_reader.h"
#include "radcert/study/problem.h"

namespace radcert {

struct MeshSurvey;

/// The parts of a problem file, each read from its own place in it.
/// Source    the file format radcert/problem/1
/// Requires  pieces: the names of the pieces of the problem's surface; folder: where the names of files begin
/// Result    the part with its defaults filled in; otherwise InputError with the JSON pointer
/// Limits    single values only: check() looks at the whole
SurfaceChoice read_surface(const JsonReader& surface, const std::filesystem::path& folder);
TriangulationChoice read_triangulation(const JsonReader& triangulation, std::span<const std::string> pieces);
/// What `events` asks for, where it does: the cut itself depends on the whole problem.
struct WantedEvents {
  std::optional<Rational> secondary = std::nullopt;
};
std::optional<WantedEvents> read_events(const JsonReader& events);
/// Whether the grading is left to the edges: `edges`.
bool is_edge_grading(const JsonReader& grading);
std::optional<InterpolatedGeometry> read_geometry(const JsonReader& geometry);
Method read_method(const JsonReader& basis, const std::filesystem::path& folder);
TriangleBasisChoice read_triangle_basis(const JsonReader& basis, const std::filesystem::path& folder);
Meshless read_meshless(const JsonReader& basis);
Galerkin read_galerkin(const JsonReader& basis);
QuadratureChoice read_quadrature(const JsonReader& quadrature);
SolverChoice read_solver(const JsonReader& solver);
OperatorChoice read_operator(const JsonReader& matrix);
Guarantee read_guarantee(const JsonReader& guarantee, std::span<const std::string> pieces);
PiecewiseExpression read_piecewise(const JsonReader& expression, std::span<const std::string> pieces);
/// The names of the pieces of a surface.
std::vector<std::string> pieces_of(const SurfaceChoice& surface);
/// A short name, which is a cell of a CSV table and a line of a legend as it is.
std::string read_label(const JsonReader& label);
/// The level with which fitted orders begin.
int read_fit_from(const JsonReader& level);

/// Why a mesh is no surface of a problem, if so.
/// Requires  front_allowed: how its user chooses the side where light is
[[nodiscard]] std::optional<InputFault> mesh_surface_fault(const std::string& name, const MeshSurvey& survey,
                                                           const std::string& front_allowed);
/// A mesh as the surface of a problem. Requires one without such a fault, and what it was surveyed with.
[[nodiscard]] SurfaceChoice mesh_surface_choice(const std::string& name, const MeshSurvey& survey,
                                                const Rational& angle, const std::vector<std::string>& repair,
                                                FrontRule front);

/// The same parts as JSON.
/// Source    the file format radcert/problem/1
/// Requires  a part that the functions above could have read
/// Result    every default written out
JsonValue surface_json(const SurfaceChoice& surface);
JsonValue triangulation_json(const TriangulationChoice& triangulation);
JsonValue geometry_json(const std::optional<InterpolatedGeometry>& geometry);
JsonValue method_json(const Method& method);
JsonValue triangle_basis_json(const TriangleBasisChoice& basis);
JsonValue meshless_json(const Meshless& method);
JsonValue galerkin_json(const Galerkin& method);
JsonValue quadrature_json(const QuadratureChoice& quadrature);
JsonValue solver_json(const SolverChoice& solver);
JsonValue operator_json(const OperatorChoice& matrix);
JsonValue guarantee_json(const Guarantee& guarantee);
JsonValue piecewise_json(const PiecewiseExpression& expression);

/// The words that a problem file may have at a place.
/// Source    the file format radcert/problem/1
/// Result    in the order of messages and of the schema
std::vector<std::string> surface_names();  ///< surfaces of the catalogue without parts that hide others
std::vector<std::string> pattern_names();
std::vector<std::string> diagonal_names();
std::vector<std::string> data_point_names();
std::vector<std::string> solvers_without_tolerance();
std::vector<std::string> guaranteed_quantities();  ///< in the order of EnclosedQuantity
std::string name_of(EnclosedQuantity quantity);
std::vector<std::string> triangle_basis_families();
std::vector<std::string> meshless_families();
std::vector<std::string> named_meshless_families();  ///< those that have all defaults
std::vector<std::string> site_distance_names();
std::vector<std::string> normalisation_names();
std::vector<std::string> too_few_neighbours_names();
std::vector<std::string> weight_rule_names();
std::vector<std::string> coefficient_rule_names();

/// A method in words: what its functions are; of a meshless one its sites, weights and coefficients.
[[nodiscard]] std::vector<std::string> method_words(const Method& method);
[[nodiscard]] std::vector<std::string> triangle_basis_words(const TriangleBasisChoice& basis);
[[nodiscard]] std::vector<std::string> meshless_words(const Meshless& method);
[[nodiscard]] std::vector<std::string> galerkin_words(const Galerkin& method);

/// Refuses the `digest` of an object, where it is given, unless it is that of the file.
void require_digest(const JsonReader& object, const std::string& digest);

/// An exact number as JSON.
/// Source    the file format: a JSON number means the nearest double, a string is exact
/// Requires  nothing
/// Result    a whole number up to 2^53 as a number, everything else as a string: 2, "1/6"
JsonValue exact_json(const Rational& value);
/// [x, y, z], each exactly, as a text.
JsonValue point_json(const Vector<Rational>& point);

/// Requires that each piece, or "*", is named; refuses other names.
/// Requires  an object
/// Result    returns, or throws InputError
void require_pieces(const JsonReader& by_piece, std::span<const std::string> pieces);

}  // namespace radcert
