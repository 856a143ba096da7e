// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/known_problems.h"

#include <utility>

#include "radcert/expression/parse.h"

namespace radcert::verification::ac98 {

PiecewiseExpression on_all_pieces(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

Problem linear_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                       const std::string& reflectivity) {
  Problem problem;
  problem.surface = {.name = surface, .parameters = std::move(parameters)};
  problem.triangulation.levels = {0};
  problem.method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}};
  problem.reflectivity = on_all_pieces(reflectivity);
  return problem;
}

Problem linear_problem_with_solution(const std::string& surface, std::vector<SurfaceParameter> parameters,
                                     const std::string& reflectivity, const std::string& solution) {
  return known_problem(surface, std::move(parameters), reflectivity, solution, 1, Rational(1, 6));
}

Problem known_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                      const std::string& reflectivity, const std::string& solution, int degree,
                      const Rational& alpha) {
  Problem problem = linear_problem(surface, std::move(parameters), reflectivity);
  problem.method = Collocation{{.degree = degree, .alpha = alpha}};
  problem.solution = on_all_pieces(solution);
  return problem;
}

Problem by_centroids(Problem problem) {
  problem.method = Collocation{{.degree = 0, .alpha = Rational(0)}};
  return problem;
}

}  // namespace radcert::verification::ac98
