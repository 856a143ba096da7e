// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/expression/parse.h"
#include "radcert/study/problem.h"
#include "radcert/study/study.h"

namespace radcert::testing {

inline Expression expression(const std::string& text) { return parse_expression(text).value(); }

/// One expression for all pieces.
inline PiecewiseExpression everywhere(const std::string& text) { return {{{"*", expression(text)}}}; }

inline PiecewiseExpression by_piece(const std::vector<std::pair<std::string, std::string>>& cases) {
  PiecewiseExpression function;
  for (const auto& [piece, text] : cases) function.cases.push_back({piece, expression(text)});
  return function;
}

/// A problem that `check` admits: rho = 1/2, u = 1, degree 1 with the inset 1/6, level 0.
inline Problem sample_problem(const std::string& surface, std::vector<SurfaceParameter> parameters = {}) {
  return {.surface = {.name = surface, .parameters = std::move(parameters)},
          .triangulation = {.levels = {0}, .pattern = {}, .grading = 1},
          .method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}},
          .reflectivity = everywhere("1/2"),
          .solution = everywhere("1"),
          .emission = std::nullopt,
          .solver = {}};
}

inline Problem with_emission(Problem problem, const std::string& emission) {
  problem.solution = std::nullopt;
  problem.emission = everywhere(emission);
  return problem;
}

inline Problem with_solution(Problem problem, const std::string& solution) {
  problem.solution = everywhere(solution);
  problem.emission = std::nullopt;
  return problem;
}

inline Problem with_basis(Problem problem, int degree, std::optional<Rational> alpha) {
  problem.method = Collocation{{.degree = degree, .alpha = std::move(alpha)}};
  return problem;
}

/// The second route of a problem that gives E: nobody asks for Ku.
inline AppliedOperator no_route(const Surface&, const SurfaceFunction&) {
  ADD_FAILURE() << "E is given, and Ku was asked for";
  return [](const SurfacePoint<double>&) { return Approximation{}; };
}

/// The fault of the InputError that an action throws; an empty one, and a failure, if it throws none.
inline InputFault fault_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.fault();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

}  // namespace radcert::testing
