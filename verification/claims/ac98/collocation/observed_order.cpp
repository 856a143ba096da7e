// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/observed_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/expression/parse.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::verification::ac98 {
namespace {

PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

bool at_the_border(const Surface& surface, const ParameterTriangle& triangle) {
  const bool square = surface.charts.at(triangle.chart).facts().domain == ChartDomain::unit_square;
  return std::any_of(triangle.vertices.begin(), triangle.vertices.end(), [square](const auto& v) {
    return v.s == 0 || v.t == 0 || (square ? v.s == 1 || v.t == 1 : v.s + v.t == 1);
  });
}

}  // namespace

Problem known_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                      const std::string& reflectivity, const std::string& solution, int degree,
                      const Rational& alpha) {
  Problem problem;
  problem.surface = {.name = surface, .parameters = std::move(parameters)};
  problem.triangulation.levels = {0};
  problem.method = Collocation{{.degree = degree, .alpha = alpha}};
  problem.reflectivity = everywhere(reflectivity);
  problem.solution = everywhere(solution);
  return problem;
}

Approximation order_between(const Approximation& coarse, const Approximation& fine, int steps) {
  const double lowest_coarse = coarse.value - coarse.radius;
  const double lowest_fine = fine.value - fine.radius;
  if (!(lowest_coarse > 0) || !(lowest_fine > 0)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {.value = infinity, .radius = infinity};
  }
  const double value = std::log2(coarse.value / fine.value) / steps;
  const double low = std::log2(lowest_coarse / (fine.value + fine.radius)) / steps;
  const double high = std::log2((coarse.value + coarse.radius) / lowest_fine) / steps;
  return {.value = value, .radius = std::max(value - low, high - value)};
}

NodeErrors node_errors(const Bench& bench, const Problem& problem, int level) {
  const LevelOutcome outcome = bench.levels.level(problem, level);
  const Surface surface = surface_of(problem);
  const std::vector<ParameterTriangle> triangles = triangulate(surface, level).triangles;
  NodeErrors errors;
  for (const NodeValue& node : outcome.nodes) {
    const double error = std::abs(node.u_n.value - node.u.value());
    Approximation& part =
        at_the_border(surface, triangles.at(node.element)) ? errors.at_seams : errors.inside;
    errors.all.value = std::max(errors.all.value, error);
    part.value = std::max(part.value, error);
  }
  const double radius = as_sampled(outcome.result.node_error.value()).radius;
  for (Approximation* each : {&errors.all, &errors.at_seams, &errors.inside}) each->radius = radius;
  return errors;
}

}  // namespace radcert::verification::ac98
