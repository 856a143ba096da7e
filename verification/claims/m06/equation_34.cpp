// SPDX-License-Identifier: GPL-3.0-or-later

// (34)-(35) put g = u |D_s m_k x D_t m_k| and Phi = G. The method (19) interpolates u alone, so that the
// error at v_i is the sum of Int Phi (I - L) g with Phi = G |D_s m_k x D_t m_k| and g = u: for the g of (35)
// it would be the error of another method, which interpolates u times the area element. On plane pieces the
// two are one; the proof of Theorem 7 holds for the right pair with the same orders.
//
// Checked      on the first octant of the sphere, where G = 1/4, as one element, r = 1, alpha = 1/6, u = 1:
//              the error of the method is zero, as P_n 1 = 1; with the g of (35) it is not. On a plane
//              triangle both are zero. By a Gauss rule, enclosed arithmetic around it.
// Not checked  nothing is left of (35). (34) itself has t for k in one index, and i up to 6n for n f_r.

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// The rule's sum of 1/4 (I - L) g over the unit triangle of a chart with g = J, the area element, or of 1/4 J
// (I - L) 1.
Ball left_over(const Chart& chart, bool as_printed) {
  constexpr int order = 12;
  const InsetBasis<Ball> basis(1, Ball(Rational(1, 6)));
  const auto area = [&](const Barycentric<Ball>& x) {
    return area_element(chart.in<Ball>().frame({x.x[2], x.x[1]}));
  };
  std::vector<Ball> at_nodes;
  for (const Barycentric<Ball>& q : basis.nodes()) at_nodes.push_back(as_printed ? area(q) : Ball(1));
  const TriangleRule<Ball> rule = conical_rule<Ball>(order, Grading::none);
  std::vector<Ball> values(basis.size());
  Ball sum = 0;
  for (std::size_t p = 0; p < rule.points.size(); ++p) {
    basis.values(rule.points[p], std::span<Ball>(values));
    const Ball here = area(rule.points[p]);
    Ball rest = as_printed ? here : Ball(1);
    for (std::size_t j = 0; j < values.size(); ++j) rest -= at_nodes[j] * values[j];
    sum += rule.weights[p] * rest * (as_printed ? Ball(1) : here);
  }
  return sum / Ball(4);
}

}  // namespace

Finding equation_34(const Bench&) {
  const BallPrecision precision(128);
  const Surface curved = sphere();
  const Surface plane = octahedron();
  const AgreesWith of_the_method{.value = left_over(curved.charts[0], false), .within = 1e-12};
  Finding finding;
  finding.require("1/4 J (I - L) 1 over an octant of the sphere",
                  AgreesWith{.value = Ball(0), .within = 1e-25}, of_the_method.value);
  finding.require("1/4 (I - L) J over a face of the octahedron", of_the_method,
                  left_over(plane.charts[0], true));
  finding.require("1/4 (I - L) J over an octant of the sphere, as (35) has it", of_the_method,
                  left_over(curved.charts[0], true));
  finding.control("the area of the octant in its place", of_the_method, Ball::pi() / Ball(2));
  return finding;
}

}  // namespace radcert::verification::m06
