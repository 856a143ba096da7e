// SPDX-License-Identifier: GPL-3.0-or-later

// (34)-(35) put g = u |D_s m_k x D_t m_k| and Phi = G. The method (19) interpolates u alone, so that the
// error at v_i is the sum of Int Phi (I - L) g with Phi = G |D_s m_k x D_t m_k| and g = u: for the g of (35)
// it would be the error of another method, which interpolates u times the area element. On plane pieces the
// two are one; the proof of Theorem 7 holds for the right pair with the same orders.
//
// Checked      on the first octant of the sphere, where G = 1/4, as one element, r = 1, alpha = 1/6, u = 1:
//              the error of the method is zero, as the l_j sum to 1 at the points of a Gauss rule; with the g
//              of (35) it is not: Int J = pi/2 is the octant's area, and Int L J the rule of degree 1, J/6 at
//              the three nodes, both without quadrature. On a plane triangle, where J = 2 times the area,
//              both are zero. Rejected: u = 1 with the value at one node moved.
// Not checked  nothing is left of (35). (34) itself has t for k in one index, and i up to 6n for n f_r.

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// 1/4 of an area less the rule of the nodes for J, the area element.
Ball as_printed(const Chart& chart, const Ball& area) {
  Ball sum = area;
  for (const Barycentric<Ball>& q : InsetBasis<Ball>(1, Ball(Rational(1, 6))).nodes())
    sum -= area_element(chart.in<Ball>().frame({q.x[2], q.x[1]})) / Ball(6);
  return sum / Ball(4);
}

// A Gauss rule's sum of 1/4 J (I - L) 1 over the unit triangle of a chart, J the area element, the value at
// the first node moved.
Ball of_the_method(const Chart& chart, const Ball& moved) {
  constexpr int order = 12;
  const InsetBasis<Ball> basis(1, Ball(Rational(1, 6)));
  const auto area = [&](const Barycentric<Ball>& x) {
    return area_element(chart.in<Ball>().frame({x.x[2], x.x[1]}));
  };
  std::vector<Ball> at_nodes(basis.size(), Ball(1));
  at_nodes.front() += moved;
  const TriangleRule<Ball> rule = conical_rule<Ball>(order, Grading::none);
  std::vector<Ball> values(basis.size());
  Ball sum = 0;
  for (std::size_t p = 0; p < rule.points.size(); ++p) {
    basis.values(rule.points[p], std::span<Ball>(values));
    const Ball here = area(rule.points[p]);
    Ball rest(1);
    for (std::size_t j = 0; j < values.size(); ++j) rest -= at_nodes[j] * values[j];
    sum += rule.weights[p] * rest * here;
  }
  return sum / Ball(4);
}

}  // namespace

Finding equation_34(const Bench&) {
  const BallPrecision precision(128);
  const Surface curved = sphere();
  const Surface plane = octahedron();
  const AgreesWith zero{.value = Ball(0), .within = 1e-25};
  // A face of the octahedron of radius 1 has the sides sqrt 2.
  const Ball face = sqrt(Ball(3)) / Ball(2);
  Finding finding;
  finding.require("1/4 J (I - L) 1 over an octant of the sphere", zero,
                  of_the_method(curved.charts[0], Ball(0)));
  finding.require("1/4 (I - L) J over a face of the octahedron", zero, as_printed(plane.charts[0], face));
  finding.require("1/4 (I - L) J over an octant of the sphere, as (35) has it", zero,
                  as_printed(curved.charts[0], Ball::pi() / Ball(2)));
  finding.control("1/4 J (I - L) 1 over an octant of the sphere, 1 moved by 1/10 at one node", zero,
                  of_the_method(curved.charts[0], Ball(Rational(1, 10))));
  return finding;
}

}  // namespace radcert::verification::m06
