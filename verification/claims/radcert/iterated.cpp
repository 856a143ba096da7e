// SPDX-License-Identifier: GPL-3.0-or-later

// The iterated solution uhat = E + K u_n off the nodes.
//
// Checked      iterated_superconvergence: max |u - uhat| over six points inside every element, none of them a
//              node, on two_piece(2), two smooth pieces that do not meet, and on the ellipsoid (1, 5/4, 3/2),
//              u = exp(x/2 + y/3 - z/4), rho = 1/2: h^4 |log h| for linear functions at alpha = 1/6, h^5
//              |log h| for quadratic ones at symmetric nodes; u_n itself over the same points on two_piece:
//              h^2 and h^3. Rejected: these orders for u_n, and h^4 |log h| for uhat of linear functions at
//              alpha = 1/10, whose nodes gain no order. E = u - Ku by the second route, K u_n by the
//              integrals of the matrix.
// Not checked  the logarithm apart from its power; points on the seams of charts; other degrees.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/study/study.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::radcert {
namespace {

PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

Problem problem_on(SurfaceChoice surface, TriangleBasisChoice basis) {
  Problem problem;
  problem.surface = std::move(surface);
  problem.triangulation.levels = {1, 2, 3};
  problem.method = Collocation{std::move(basis)};
  problem.reflectivity = everywhere("1/2");
  problem.solution = everywhere("exp(x/2 + y/3 - z/4)");
  problem.iterated = true;
  return problem;
}

SurfaceChoice two_piece() { return {.name = "two_piece", .parameters = {{"p", 2}}}; }
SurfaceChoice ellipsoid() {
  return {.name = "ellipsoid", .parameters = {{"a", 1}, {"b", Rational(5, 4)}, {"c", Rational(3, 2)}}};
}

TriangleBasisChoice linear(const Rational& alpha) { return {.degree = 1, .alpha = alpha}; }
TriangleBasisChoice quadratic() {
  constexpr int degree = 2;
  return {.degree = degree,
          .family = NodeFamily::symmetric,
          .functions = std::make_shared<const LagrangeFunctions>(
              lagrange_functions(symmetric_nodes(degree).nodes()).value())};
}

/// The order of an error of the levels of a problem.
template <class Error>
ObservedOrder order_of(const Bench& bench, const Problem& problem, const Error& error, bool with_logarithm) {
  return observed_order(
      over_levels(problem.triangulation.levels,
                  [&](int level) { return error(bench.levels.level(problem, level).result).value(); }),
      OrderModel{.logarithm = with_logarithm});
}

ObservedOrder iterated_order(const Bench& bench, const Problem& problem) {
  return order_of(
      bench, problem, [](const LevelResult& level) { return level.iterated_error; }, true);
}

ObservedOrder own_order(const Bench& bench, const Problem& problem, bool with_logarithm) {
  return order_of(
      bench, problem, [](const LevelResult& level) { return level.iterated->u_n_error; }, with_logarithm);
}

}  // namespace

Finding iterated_superconvergence(const Bench& bench) {
  const Order four = Order::at_least(4);
  const Order five = Order::at_least(5);
  const Problem linear_on_pieces = problem_on(two_piece(), linear(Rational(1, 6)));
  const Problem linear_on_ellipsoid = problem_on(ellipsoid(), linear(Rational(1, 6)));
  const Problem quadratic_on_pieces = problem_on(two_piece(), quadratic());
  const std::string points = " over the check points, ";
  Finding finding;
  finding.require("order of max |u - E - K u_n|" + points + "two_piece, r = 1, alpha = 1/6", four,
                  iterated_order(bench, linear_on_pieces));
  finding.require("order of max |u - E - K u_n|" + points + "ellipsoid, r = 1, alpha = 1/6", four,
                  iterated_order(bench, linear_on_ellipsoid));
  finding.require("order of max |u - E - K u_n|" + points + "two_piece, r = 2, symmetric nodes", five,
                  iterated_order(bench, quadratic_on_pieces));
  const std::string of_own = "order of max |u - u_n|" + points + "two_piece, ";
  finding.require(of_own + "r = 1, alpha = 1/6", Order::is(2), own_order(bench, linear_on_pieces, false));
  finding.require(of_own + "r = 2, symmetric nodes", Order::is(3),
                  own_order(bench, quadratic_on_pieces, false));
  finding.control(of_own + "r = 1, alpha = 1/6, with |log h|", four,
                  own_order(bench, linear_on_pieces, true));
  finding.control(of_own + "r = 2, symmetric nodes, with |log h|", five,
                  own_order(bench, quadratic_on_pieces, true));
  finding.control("order of max |u - E - K u_n|" + points + "two_piece, r = 1, alpha = 1/10", four,
                  iterated_order(bench, problem_on(two_piece(), linear(Rational(1, 10)))));
  return finding;
}

}  // namespace radcert::verification::radcert
