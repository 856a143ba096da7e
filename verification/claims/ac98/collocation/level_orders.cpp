// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/level_orders.h"

#include <utility>

#include "radcert/core/contract.h"
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
  Problem problem = linear_problem(surface, std::move(parameters), reflectivity);
  problem.solution = on_all_pieces(solution);
  return problem;
}

Approximation observed_order(LevelSource& levels, const Problem& problem, LevelError error, int level) {
  expects(level >= 1, "a level with one before it", named("level", level));
  const auto of_level = [&](int at) {
    const std::optional<Approximation> figure = levels.level(problem, at).result.*error;
    expects(figure.has_value(), "a problem with a known solution");
    return as_sampled(*figure);
  };
  return order_between(of_level(level - 1), of_level(level));
}

}  // namespace radcert::verification::ac98
