// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/formats/problem/problem_json.h"
#include "radcert/study/study.h"

namespace radcert::test {

inline const std::string sample_problem_text = R"json({
  "schema": "radcert/problem/1",
  "surface": {"name": "two_piece", "p": 2},
  "triangulation": {"levels": [0, 1, 2]},
  "basis": {"family": "inset", "degree": 1, "alpha": "1/6"},
  "reflectivity": "1",
  "solution": "1/sqrt(x^2 + y^2 + (z-1/2)^2)"})json";

inline Problem sample_problem() { return parse_problem(sample_problem_text, "sample"); }

/// A level with numbers that a careless writer would round.
inline LevelOutcome sample_level() {
  LevelOutcome level;
  level.result.level = 3;
  level.result.elements = 2;
  level.result.unknowns = 6;
  level.result.mesh_size = 0.1;
  level.result.discretisation_error = Approximation{.value = 1.0 / 3, .radius = 5e-324, .guaranteed = false};
  level.result.node_error = Approximation{
      .value = 0x1.fffffffffffffp-1, .radius = std::numeric_limits<double>::infinity(), .guaranteed = true};
  level.result.piece_means = {{"upper", Approximation::estimated(0.30000000000000004, 1.0 / 7)},
                              {"lower", Approximation::without_radius(-1e300)}};
  level.result.solution_radius = 1.0 / 7;
  level.result.norm_K = {.value = 0.7, .radius = 0x1p-55, .guaranteed = true};
  level.result.planned_bytes = 0xffffffffffffffffU;
  level.result.iteration = {
      .iterations = 0xffffffffffffffffU, .contraction = 0.1 + 0.2, .error_bound = 5e-324};
  level.result.verified = {.theta = 0.1 + 0.7};
  level.timing = {.assembly_seconds = 0.1, .operator_seconds = 0.2, .solve_seconds = 0.30000000000000004};
  level.nodes = {{.piece = "upper",
                  .element = 1,
                  .index_in_element = 2,
                  .point = {0.1, -0.0, 3},
                  .normal = {0, 0, 1},
                  .u_n = Approximation::proved(1.0 / 7, 0.1 + 0.2),
                  .emission = 2.0 / 7,
                  .u = 3.0 / 7},
                 {.piece = "lower, \"left\"",
                  .element = 0,
                  .index_in_element = 0,
                  .point = {1, 2, 3},
                  .normal = {0, 1, 0},
                  .u_n = Approximation::without_radius(1e-310),
                  .emission = -5,
                  .u = std::nullopt}};
  level.elements = {{.piece = "upper",
                     .corners = {Vector<double>{0, 0, 0}, Vector<double>{1, 0, 0.1}, Vector<double>{0, 1, 0}},
                     .corner_values = {1.0 / 3, 2, 3}},
                    {.piece = "lower",
                     .corners = {Vector<double>{1, 0, 0}, Vector<double>{1, 1, 0}, Vector<double>{0, 1, 0}},
                     .corner_values = {4, 5, -6}}};
  return level;
}

}  // namespace radcert::test
