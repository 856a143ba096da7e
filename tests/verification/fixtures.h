// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/study/study.h"
#include "tests/core/temporary_folder.h"
#include "verification/framework/finding.h"

namespace radcert::verification {

// How a failed expectation shows a verdict or a standing.
inline void PrintTo(Verdict verdict, std::ostream* out) { *out << name(verdict); }
inline void PrintTo(Standing standing, std::ostream* out) { *out << name(standing); }

inline PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

/// A problem on the cube; nothing here solves it.
inline Problem flat_problem(std::vector<int> levels) {
  Problem problem;
  problem.surface = {.name = "cube", .parameters = {}};
  problem.triangulation.levels = std::move(levels);
  problem.method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}};
  problem.reflectivity = everywhere("0.5");
  problem.solution = everywhere("x");
  return problem;
}

/// A level with figures that are made up: node error 2^-(2 level), discretisation error 3 times that; for
/// alpha = 1/10 ten times as much.
inline LevelOutcome made_up_level(const Problem& problem, int level) {
  LevelOutcome outcome;
  outcome.result.level = level;
  outcome.result.elements = std::uint64_t{12} << static_cast<unsigned>(2 * level);
  outcome.result.unknowns = 3 * outcome.result.elements;
  outcome.result.mesh_size = std::ldexp(1.0, -level);
  const double factor = triangle_basis_of(problem.method).alpha == Rational(1, 10) ? 10 : 1;
  outcome.result.node_error =
      Approximation{.value = factor * std::ldexp(1.0, -2 * level), .radius = 1e-12, .guaranteed = false};
  outcome.result.discretisation_error =
      Approximation{.value = 3 * factor * std::ldexp(1.0, -2 * level), .radius = 1e-12, .guaranteed = false};
  // A level that is kept without nodes is computed again.
  outcome.nodes.emplace_back();
  return outcome;
}

}  // namespace radcert::verification
