// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoreboard/entries.h"

#include <string_view>
#include <utility>

#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "scoreboard/scenes.h"

namespace radcert::app {

namespace {

/// A mesh as a surface; edges whose normals make more than `angle` degrees part pieces.
SurfaceChoice mesh_choice(const EmbeddedMesh& mesh, const Rational& angle, FrontRule front) {
  const std::string name(mesh.name);
  const MeshSurvey survey =
      survey_mesh(parse_mesh_file(mesh.text, name), angle.to_double(), MeshRepair{}, front);
  return mesh_surface_choice(name, survey, angle, {}, front);
}

}  // namespace

std::span<const BoardMethod> board_methods() {
  static const std::vector<BoardMethod> methods = {
      {.name = "constant", .keys = R"json({"basis": {"family": "inset", "degree": 0}})json", .more = 1},
      {.name = "linear, alpha 1/10",
       .keys = R"json({"basis": {"family": "inset", "degree": 1, "alpha": "1/10"}})json"},
      {.name = "linear, alpha 1/6",
       .keys = R"json({"basis": {"family": "inset", "degree": 1, "alpha": "1/6"}, "iterated": true})json",
       .iterated = "iterated linear, alpha 1/6"},
      {.name = "linear, alpha 1/6, graded",
       .keys = R"json({"basis": {"family": "inset", "degree": 1, "alpha": "1/6"}})json",
       .grading = "edges"},
      {.name = "symmetric nodes, degree 2",
       .keys = R"json({"basis": {"family": "symmetric", "degree": 2}, "iterated": true})json",
       .iterated = "iterated symmetric, degree 2"},
      {.name = "symmetric nodes, degree 4",
       .keys = R"json({"basis": {"family": "symmetric", "degree": 4}})json",
       .more = -1},
      {.name = "Galerkin, constant", .keys = R"json({"basis": {"method": "galerkin", "degree": 0}})json"},
      {.name = "Galerkin, linear",
       .keys = R"json({"basis": {"method": "galerkin", "degree": 1}})json",
       .more = -1},
      {.name = "meshless, Shepard", .basis = R"json({"family": "shepard"})json", .meshless = true},
      {.name = "meshless, Gaussian",
       .basis =
           R"json({"family": "meshless", "mother": "gaussian", "normalise": "partition_of_unity", "radius": {"neighbour": 10, "too_few": "farthest"}})json",
       .meshless = true},
      {.name = "meshless, Lehtinen",
       .basis = R"json({"family": "lehtinen", "radius": {"neighbour": 10, "too_few": "farthest"}})json",
       .meshless = true},
  };
  return methods;
}

std::vector<BoardScene> board_scenes() {
  constexpr int sharp = 60;
  return {
      {.name = "sphere",
       .words = "the unit sphere, rho = 1/2, u = exp(x/2 + y/3 - z/4)",
       .truth = "u is given, and E made of it",
       .keys = R"json({"surface": {"name": "sphere"}, "reflectivity": "1/2",
                   "solution": "exp(x/2 + y/3 - z/4)"})json",
       .finest = 2,
       .separation = "2/5"},
      {.name = "ellipsoid",
       .words = "the ellipsoid with the half axes 1, 3/4 and 1/2, rho = 1/2, u = exp(x/2 + y/3 - z/4)",
       .truth = "u is given, and E made of it",
       .keys =
           R"json({"surface": {"name": "ellipsoid", "a": 1, "b": "3/4", "c": "1/2"}, "reflectivity": "1/2",
                   "solution": "exp(x/2 + y/3 - z/4)"})json",
       .finest = 2,
       .separation = "3/10"},
      {.name = "cube",
       .words = "the unit cube, rho = 1/2, the floor emits 1",
       .truth =
           "the means over floor, ceiling and walls are enclosed, u itself is not known: errors of the mean "
           "alone",
       .keys =
           R"json({"surface": {"name": "cube"}, "reflectivity": "1/2", "emission": {"floor": "1", "*": "0"}})json",
       .finest = 2,
       .separation = "3/10",
       .enclosed = "cube_rho_1/2",
       .means = {{"floor", "continuous_mean_cube_floor_rho_1/2"},
                 {"ceiling", "continuous_mean_cube_ceiling_rho_1/2"},
                 {"west", "continuous_mean_cube_wall_rho_1/2"},
                 {"east", "continuous_mean_cube_wall_rho_1/2"},
                 {"south", "continuous_mean_cube_wall_rho_1/2"},
                 {"north", "continuous_mean_cube_wall_rho_1/2"}}},
      {.name = "l_room",
       .words = "a room around a corner, rho = 1/2, u = exp(x/2 + y/3 - z/4)",
       .truth = "no solution is enclosed well enough to tell methods apart: u is given, and E made of it",
       .keys = R"json({"reflectivity": "1/2", "solution": "exp(x/2 + y/3 - z/4)"})json",
       .mesh = mesh_choice(l_room_mesh(), Rational(sharp) / Rational(2), FrontRule::automatic),
       .finest = 2,
       .separation = "2/5"},
      {.name = "sphere_over_disk",
       .words = "a sphere of 32 triangles over a disk of 8, rho = 1/2, u = exp(x/2 + y/3 - z/4)",
       .truth =
           "curved parts that hide each other are refused by solve, so that both have facets; u is given, "
           "and E made of it",
       .keys = R"json({"reflectivity": "1/2", "solution": "exp(x/2 + y/3 - z/4)"})json",
       .mesh = mesh_choice(sphere_over_disk_mesh(), Rational(sharp), FrontRule::right_hand),
       .finest = 2,
       .separation = "1/2"},
  };
}

Problem board_problem(const BoardScene& scene, const BoardMethod& method) {
  const std::string source = "scoreboard, " + scene.name + ", " + method.name;
  JsonValue problem = JsonValue::object();
  problem.set("schema", "radcert/problem/1");
  const auto add = [&](const std::string& keys) {
    const JsonValue part = parse_json(keys, source);
    for (const auto& [key, value] : *part.members()) problem.set(key, value);
  };
  add(scene.keys);
  if (method.meshless) {
    JsonValue basis = parse_json(method.basis, source);
    basis.set("sites", JsonValue::object({{"poisson_disk", scene.separation}}));
    problem.set("basis", std::move(basis));
  } else {
    add(method.keys);
  }
  JsonValue levels = JsonValue::array();
  for (int level = method.first; level <= scene.finest + method.more; ++level) levels.push(level);
  problem.set("triangulation",
              JsonValue::object({{"levels", std::move(levels)}, {"grading", method.grading}}));
  // Errors of methods are far above this; integrals over two elements cost more.
  const bool is_of_pairs = method.name.starts_with("Galerkin");
  problem.set("quadrature", JsonValue::object({{"tolerance", is_of_pairs ? "1e-7" : "1e-10"}}));
  return problem_of(problem, source, scene.mesh);
}

}  // namespace radcert::app
