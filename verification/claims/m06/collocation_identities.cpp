// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (19) at every node of two_piece(2), r = 2 and 3, rho = 1/2 + x/4: u_n as the pipeline solved
//              it, its integrals element by element by cubature that shares nothing with the matrix. The page
//              has rho(P) for rho(v_i), and the sum over j to n f_r for f_r. (25) at points that are no
//              nodes: K u by the second route, K u_n, K P_n (u - hat u_n) and K(u - P_n u) by that cubature;
//              P_n hat u_n = P_n u_n = u_n. The same identity with P_n left out is rejected.
// Not checked  other surfaces; finer levels.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/expression/parse.h"
#include "radcert/reference/operator_integral.h"
#include "verification/claims/ac98/collocation/element_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using ac98::ElementFunction;

Problem test_problem(int r) {
  Problem problem;
  problem.surface = {.name = "two_piece", .parameters = {{"p", 2}}};
  problem.triangulation.levels = {0, 1};
  problem.method = Collocation{{.degree = r, .alpha = Rational(1, 10)}};
  problem.reflectivity = {.cases = {{"*", parse_expression("1/2 + x/4").value()}}};
  problem.solution = {.cases = {{"*", parse_expression("exp(x/2 + y/3 - z/4)").value()}}};
  return problem;
}

Vector<double> place(const ElementFunction& u_n, const SurfacePoint<double>& p) {
  return u_n.surface().charts[p.chart].in<double>().frame(p.at).point;
}

double rho_over_pi(const Vector<double>& p) { return (0.5 + p.x / 4) / std::numbers::pi; }

double exact(const Vector<double>& q) { return std::exp(q.x / 2 + q.y / 3 - q.z / 4); }

void keep_furthest(Approximation& furthest, const Approximation& difference) {
  if (std::abs(difference.value) > std::abs(furthest.value)) furthest.value = difference.value;
  furthest.radius = std::max(furthest.radius, difference.radius);
}

// The two sides of (19), furthest apart over the nodes; rho at the node moved by `shift` in x.
Approximation residual(const ElementFunction& u_n, const LevelOutcome& level, double shift) {
  Approximation furthest{.value = 0, .radius = 0};
  for (const NodeValue& node : level.nodes) {
    const SurfacePoint<double> p = u_n.node(node.element, node.index_in_element);
    Vector<double> at = place(u_n, p);
    at.x += shift;
    const Approximation integral = u_n.integral(p);
    keep_furthest(furthest, {.value = u_n.node_value(node.element, node.index_in_element) -
                                      rho_over_pi(at) * integral.value - node.emission,
                             .radius = rho_over_pi(at) * integral.radius});
  }
  return furthest;
}

// K(u - v)(P) for v with the values of an element function.
Approximation of_difference(const ElementFunction& v, const SurfacePoint<double>& p) {
  Approximation total{.value = 0, .radius = 0};
  for (std::size_t k = 0; k < v.triangles().size(); ++k) {
    const Approximation part = reference::operator_integral(
        v.surface(), p, v.triangles()[k].chart, v.triangles()[k].vertices,
        [&](const SurfacePoint<double>& q, const Vector<double>& x) { return exact(x) - v(k, q.at); });
    total.value += part.value;
    total.radius += part.radius;
  }
  return total;
}

}  // namespace

Finding equation_19(const Bench& bench) {
  const Equals zero{.value = 0,
                    .slack = 1e-10,
                    .why = "each row is integrated to 1e-12 of its size, and 1/(1 - norm of K) is below 10"};
  Finding finding;
  for (const int r : {2, 3}) {
    const Problem problem = test_problem(r);
    const int level = bench.budget == Budget::quick ? 0 : 1;
    const LevelOutcome outcome = bench.levels.level(problem, level);
    ElementFunction u_n(problem, outcome);
    const std::string of = ", r = " + std::to_string(r) + ", level " + std::to_string(level);
    const Approximation difference = residual(u_n, outcome, 0);
    finding.require("left less right side of (19), furthest from 0 over the nodes" + of, zero, difference);
    finding.control("the same with rho at another point" + of, zero, residual(u_n, outcome, 0.01));
    u_n.add_to_node(0, 0, 1e-6);
    finding.control("the same with one value of u_n moved by 1e-6" + of, zero, residual(u_n, outcome, 0));
    finding.show(difference);
  }
  return finding;
}

Finding equation_25(const Bench& bench) {
  const Equals zero{.value = 0, .slack = 1e-10, .why = "each integral is taken to 1e-12 of its size"};
  Finding finding;
  for (const int r : {1, 2}) {
    const Problem problem = test_problem(r);
    const LevelOutcome outcome = bench.levels.level(problem, 0);
    const ElementFunction u_n(problem, outcome);
    ElementFunction interpolant = u_n;  // P_n u
    ElementFunction rest = u_n;         // P_n u - u_n
    for (const NodeValue& node : outcome.nodes) {
      const double u = node.u.value();
      const double value = u_n.node_value(node.element, node.index_in_element);
      interpolant.add_to_node(node.element, node.index_in_element, u - value);
      rest.add_to_node(node.element, node.index_in_element, u - 2 * value);
    }
    const SurfaceFunction u(problem.solution.value(), u_n.surface());
    const AppliedOperator of_u = bench.route(u_n.surface(), u);
    Approximation furthest{.value = 0, .radius = 0};
    Approximation without{.value = 0, .radius = 0};
    for (const std::size_t element : {std::size_t{0}, std::size_t{3}}) {
      const auto& triangle = u_n.triangles()[element];
      const SurfacePoint<double> p{triangle.chart, triangle.at({0.5, 0.3, 0.2})};
      const Approximation whole = of_u(p);
      const Approximation of_u_n = u_n.integral(p);
      const Approximation of_rest = rest.integral(p);
      const Approximation right = of_difference(interpolant, p);
      // u - hat u_n = K u - K u_n: both are E plus an integral.
      const double factor = rho_over_pi(place(u_n, p));
      const Approximation left{.value = factor * (whole.value - of_u_n.value),
                               .radius = factor * (whole.radius + of_u_n.radius)};
      keep_furthest(furthest, {.value = left.value - factor * (of_rest.value + right.value),
                               .radius = left.radius + factor * (of_rest.radius + right.radius)});
      keep_furthest(without, {.value = left.value - factor * right.value,
                              .radius = left.radius + factor * right.radius});
    }
    const std::string of = ", r = " + std::to_string(r);
    finding.require("left less right side of (25), furthest from 0" + of, zero, furthest);
    finding.control("the same without K P_n (u - hat u_n)" + of, zero, without);
  }
  return finding;
}

}  // namespace radcert::verification::m06
