// SPDX-License-Identifier: GPL-3.0-or-later

// How far beyond Theorem 9 interpolation of degree r can go at the nodes. Let d be the degree of precision of
// the rule of symmetric nodes over a parallelogram, P a node, and u smooth. The error at P is the sum over
// the elements of Int G(P,Q) (u - P_n u) dS. Where G(P,.) is smooth, two halves of a parallelogram leave
// O(h^(d+1)) times their area, as in Lemma 8: order d + 1 in all. Near P on its own curved piece G(P,Q) =
// g_0(theta) + rho g_1(theta) + ..., in polar coordinates (rho, theta) about P: bounded, but its value at P
// depends on the direction and D^j G grows like rho^-j. Parallelograms at the distance m h then leave h^(r+3)
// m^-(d-r) each, of which there are O(m): for d > r + 2 the sum over m is bounded and stands for h^(r+3), the
// element of P itself gives O(h^(r+3)) as |u - P_n u| = O(h^(r+1)) on an area O(h^2). So the order is at
// least min(d + 1, r + 3), with |log h| for d = r + 2. This is proved up to the usual constants; that r + 3
// is not exceeded is measured.
//
// Checked      the six symmetric nodes of degree 2: precision 4 on the triangle, 5 on the parallelogram,
//              proved by Krawczyk's test. The error at the six nodes of an element in the middle of the roof
//              of two_piece(2), u = exp(2x + y), over its own piece: order 5, and neither 4 nor 6; over the
//              other piece: 6; by conical rules, collapsed at the node on its own element, the radius being
//              the distance of two orders of the rule. On the sphere, where G = 1/4, u = x^4: 6. Four levels
//              each, three over the other piece at quick; over its own piece five at standard and six at
//              full, where there would be 393,216 unknowns. At full also an element amid a chart of the
//              ellipsoid, where the order comes down to 5 and is 5.1 at level 6. And the error of the
//              collocation solution at all nodes of two_piece(2): order 5. With the nodes (13), alpha = 1/10,
//              order 4 over a node's own piece and on the sphere.
// Not checked  that the constant of h^5 is not zero for other surfaces: it is zero where the piece is plane
// or a sphere.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/m06/interpolation_remainder.h"
#include "verification/claims/m06/kernel_error.h"
#include "verification/claims/m06/named_problems.h"
#include "verification/claims/m06/sphere_errors.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::m06 {
namespace {

constexpr std::size_t lower = 0;
constexpr std::size_t upper = 1;

TriangleBasis<double> six_nodes() {
  return make_triangle_basis<double>(lagrange_functions(symmetric_nodes(2).nodes()).value());
}

double on_two_pieces(const Vector<double>& q) { return std::exp(2 * q.x + q.y); }
double on_the_ellipsoid(const Vector<double>& q) { return std::exp(q.x / 2 + q.y / 3 - q.z / 4); }

// The largest such integral over the nodes of the element of the roof that lies below and to the right of
// (1/4, 1/4).
LevelErrors errors_on_two_pieces(const TriangleBasis<double>& basis, std::size_t chart, int last) {
  const Surface surface = two_piece(2);
  return over_levels(levels_from(2, last), [&](int level) {
    const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    const double side = std::pow(0.5, level);
    const auto own = std::find_if(elements.begin(), elements.end(), [&](const ParameterTriangle& t) {
      const ParameterPoint<double> middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
      return t.chart == upper && std::abs(middle.s - (0.25 + 2 * side / 3)) < side / 8 &&
             std::abs(middle.t - (0.25 + side / 3)) < side / 8;
    });
    expects(own != elements.end(), "level >= 2, so that (1/4, 1/4) is a vertex", named("level", level));
    return kernel_error_at_nodes(surface, elements, *own, basis, on_two_pieces, chart);
  });
}

// The same on the ellipsoid (1,5/4,3/2), of the element with the right angle at (1/4, 1/4) of an octant.
LevelErrors errors_on_the_ellipsoid(const TriangleBasis<double>& basis) {
  const Surface surface = ellipsoid(1, Rational(5, 4), Rational(3, 2));
  return over_levels(levels_from(3, 6), [&](int level) {
    const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    const double side = std::pow(0.5, level);
    const auto own = std::find_if(elements.begin(), elements.end(), [&](const ParameterTriangle& t) {
      const ParameterPoint<double> middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
      return t.chart == 0 && std::abs(middle.s - (0.25 + side / 3)) < side / 8 &&
             std::abs(middle.t - (0.25 + side / 3)) < side / 8;
    });
    expects(own != elements.end(), "level >= 2, so that (1/4, 1/4) is a vertex", named("level", level));
    return kernel_error_at_nodes(surface, elements, *own, basis, on_the_ellipsoid);
  });
}

}  // namespace

Finding six_nodes_precision(const Bench&) {
  const BallPrecision precision(512);
  Finding finding;
  const auto certificate = certify(symmetric_nodes(2), 1 / power(Rational(10), 30));
  finding.require("whether Krawczyk's test fails", IsExactly{0}, Rational(certificate ? 0 : 1));
  finding.require("degree of precision on the triangle", IsExactly{4}, certificate.value().triangle.degree);
  finding.require("degree of precision on the parallelogram", IsExactly{5},
                  certificate.value().parallelogram.degree);
  const auto inset = lagrange_functions(inset_nodes(2, Rational(1, 10))).value();
  finding.control("degree of precision on the parallelogram, nodes (13) at alpha = 1/10", IsExactly{5},
                  degree_of_precision(interpolatory_rule(inset), Region::parallelogram).degree);
  // A constant condition has no zero: no nodes (13) have more than 3.
  finding.require("degree of the condition for precision 4 over a parallelogram, nodes (13), r = 2",
                  IsExactly{0}, InsetFamily(2).condition(Region::parallelogram, 4).degree());
  return finding;
}

Finding six_nodes_on_a_curved_piece(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  const Order five = Order::is(5);
  Finding finding;
  const int last = quick ? 5 : bench.budget == Budget::standard ? 6 : 7;
  const ObservedOrder own = observed_order(errors_on_two_pieces(six_nodes(), upper, last));
  finding.require("order at the nodes over their own piece", five, own);
  finding.control("order at the nodes (13), alpha = 1/10, over their own piece", five,
                  observed_order(errors_on_two_pieces(nodes_at_a_tenth(2), upper, quick ? 5 : 6)));
  if (bench.budget == Budget::full)
    finding.require("order at the nodes of an element amid a chart of the ellipsoid, levels 3 to 6",
                    Order::at_least(5), observed_order(errors_on_the_ellipsoid(six_nodes())));
  const Problem all = problem_named("two_piece_symmetric");
  finding.require("order of max |u - u_n| over all nodes, two_piece_symmetric", five,
                  observed_order(node_errors(bench, all, levels_of_an_order(all, bench.budget))));
  finding.show(own.exponent);
  return finding;
}

Finding six_nodes_without_the_obstacle(const Bench& bench) {
  const Order six = Order::is(6);
  Finding finding;
  finding.require(
      "order at the nodes over the other piece", six,
      observed_order(errors_on_two_pieces(six_nodes(), lower, bench.budget == Budget::quick ? 4 : 5)));
  finding.control("order at the nodes (13), alpha = 1/10, over the other piece", six,
                  observed_order(errors_on_two_pieces(nodes_at_a_tenth(2), lower, 4)));
  const auto on_the_sphere = [](const TriangleBasis<double>& basis, int last) {
    return observed_order(errors_on_the_sphere(basis, fourth_power, levels_from(3, last)).nodes);
  };
  const ObservedOrder order = on_the_sphere(six_nodes(), 6);
  finding.require("order on the sphere", six, order);
  finding.control("order on the sphere, nodes (13), alpha = 1/10", six,
                  on_the_sphere(nodes_at_a_tenth(2), 5));
  finding.show(order.exponent);
  return finding;
}

}  // namespace radcert::verification::m06
