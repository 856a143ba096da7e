// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (19) at every node of two_piece(2), r = 2 and 3, rho = 1/2 + x/4: u_n as the pipeline solved
//              it, its integrals element by element by cubature that shares nothing with the matrix. The page
//              has rho(P) for rho(v_i), and the sum over j to n f_r for f_r.
// Not checked  other surfaces; finer levels.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/expression/parse.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
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

}  // namespace radcert::verification::m06
