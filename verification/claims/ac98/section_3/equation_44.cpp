// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      hat u_n = E + K u_n at every node equals u_n there, K u_n integrated element by element by
//              cubature that shares nothing with the matrix; on two_piece and on the cube, degree 1, alpha =
//              1/6 and 1/10.
// Not checked  other degrees; levels beyond the second.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/expression/parse.h"
#include "verification/claims/ac98/collocation/element_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

struct Case {
  std::string name;
  Problem problem;
  int level;
  bool with_controls;
};

Case test_case(const std::string& surface, std::vector<SurfaceParameter> parameters, const std::string& rho,
               const Rational& alpha, int level, bool with_controls) {
  Problem problem;
  problem.surface = {.name = surface, .parameters = std::move(parameters)};
  problem.triangulation.levels = {level};
  problem.method = Collocation{{.degree = 1, .alpha = alpha}};
  problem.reflectivity = everywhere(rho);
  problem.solution = everywhere("x^2 + y^2 + z^2");
  return {surface + ", alpha = " + alpha.to_text() + ", level " + std::to_string(level), std::move(problem),
          level, with_controls};
}

double value_at(const PiecewiseExpression& expression, const ElementFunction& u_n,
                const SurfacePoint<double>& p) {
  const Chart& chart = u_n.surface().charts[p.chart];
  const Vector<double> x = chart.in<double>().frame(p.at).point;
  return expression.on(chart.facts().piece).evaluate<double>({x.x, x.y, x.z});
}

// hat u_n - u_n over the nodes, the one furthest from 0. `emission` holds E by node.
Approximation furthest_at_nodes(const Problem& problem, const ElementFunction& u_n,
                                const std::vector<double>& emission) {
  const std::size_t per_element = u_n.nodes_per_element();
  std::vector<Approximation> differences(emission.size());
  parallel_for(emission.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const SurfacePoint<double> p = u_n.node(i / per_element, i % per_element);
      const double factor = value_at(problem.reflectivity, u_n, p) / std::numbers::pi;
      const Approximation integral = u_n.integral(p);
      differences[i] = {
          .value = emission[i] + factor * integral.value - u_n.node_value(i / per_element, i % per_element),
          .radius = factor * integral.radius};
    }
  });
  Approximation worst{.value = 0, .radius = 0};
  for (const Approximation& each : differences) {
    if (std::abs(each.value) > std::abs(worst.value)) worst.value = each.value;
    worst.radius = std::max(worst.radius, each.radius);
  }
  return worst;
}

// hat u_n - u_n at the middle of the first element, which is no node of degree 1.
Approximation difference_off_the_nodes(const Problem& problem, const ElementFunction& u_n,
                                       const OperatorRoute& route) {
  constexpr double third = 1.0 / 3;
  const ParameterTriangle& triangle = u_n.triangles().front();
  const SurfacePoint<double> p{triangle.chart, triangle.at({third, third, third})};
  const double factor = value_at(problem.reflectivity, u_n, p) / std::numbers::pi;
  const PiecewiseExpression& u = problem.solution.value();
  const Approximation of_u = route(u_n.surface(), SurfaceFunction(u, u_n.surface()))(p);
  const Approximation of_u_n = u_n.integral(p);
  return {.value = value_at(u, u_n, p) + factor * (of_u_n.value - of_u.value) - u_n(0, p.at),
          .radius = factor * (of_u_n.radius + of_u.radius)};
}

}  // namespace

Finding equation_44(const Bench& bench) {
  const Equals zero{.value = 0,
                    .slack = 1e-10,
                    .why = "each row is integrated to 1e-12 of its size, and 1/(1 - norm of K) is below 10"};
  const SurfaceParameter square{"p", 2};
  std::vector<Case> cases{test_case("two_piece", {square}, "1", Rational(1, 6), 0, true),
                          test_case("two_piece", {square}, "1", Rational(1, 10), 1, false),
                          test_case("cube", {}, "0.5", Rational(1, 6), 0, true)};
  if (bench.budget != Budget::quick) {
    cases.push_back(test_case("cube", {}, "0.5", Rational(1, 10), 1, false));
    cases.push_back(test_case("two_piece", {square}, "1", Rational(1, 6), 2, false));
  }
  Finding finding;
  Approximation worst{.value = 0, .radius = 0};
  for (const Case& each : cases) {
    const LevelOutcome level = bench.levels.level(each.problem, each.level);
    ElementFunction u_n(each.problem, level);
    std::vector<double> emission(level.nodes.size());
    for (const NodeValue& node : level.nodes)
      emission.at(node.element * u_n.nodes_per_element() + node.index_in_element) = node.emission;
    const Approximation difference = furthest_at_nodes(each.problem, u_n, emission);
    finding.require("hat u_n - u_n, furthest from 0 over the nodes, " + each.name, zero, difference);
    if (std::abs(difference.value) + difference.radius > std::abs(worst.value) + worst.radius)
      worst = difference;
    if (!each.with_controls) continue;
    finding.control("hat u_n - u_n at the middle of an element, " + each.name, zero,
                    difference_off_the_nodes(each.problem, u_n, bench.route));
    u_n.add_to_node(0, 0, 1e-6);
    finding.control("one value of u_n moved by 1e-6, " + each.name, zero,
                    furthest_at_nodes(each.problem, u_n, emission));
  }
  finding.show(worst);
  return finding;
}

}  // namespace radcert::verification::ac98
