// SPDX-License-Identifier: GPL-3.0-or-later

// (34)-(35) put g = u |D_s m_k x D_t m_k| and Phi = G. The method (19) interpolates u alone, so that the
// error at v_i is the sum of Int Phi (I - L) g with Phi = G |D_s m_k x D_t m_k| and g = u: for the g of (35)
// it would be the error of another method, which interpolates u times the area element. On plane pieces the
// two are one; the proof of Theorem 7 holds for the right pair with the same orders.
//
// Checked      on the first octant of the sphere, where G = 1/4, as one element, r = 1, alpha = 1/6, u = 1,
//              without any quadrature. J is the area element. The error of the method is 1/4 Int J (I - L) 1:
//              at most a quarter of the octant's area pi/2 times the largest |1 - sum l_j|, which is 0 at the
//              corners, and so everywhere, as the l_j are affine. With the g of (35) it is 1/4 (Int J - Int L
//              J) = (pi/2 - sqrt 2)/4: Int J is the area, and Int L J the rule of degree 1, J/6 at the three
//              nodes. On a plane triangle, where J is twice the area, both are zero. Rejected: the method's
//              own error for u = x, 1/4 (Int x dS - sum x(q_j) Int l_j J) = (pi/4 - (pi/6) sum x(q_j))/4, as
//              permutations of the coordinates take the octant and its chart to themselves, so that Int l_j J
//              is a third of the area.
// Not checked  nothing is left of (35). (34) itself has t for k in one index, and i up to 6n for n f_r.

#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

Frame<Ball> at_node(const Chart& chart, const Barycentric<Ball>& q) {
  return chart.in<Ball>().frame({q.x[2], q.x[1]});
}

InsetBasis<Ball> basis() { return {1, Ball(Rational(1, 6))}; }

// 1/4 of an area less the rule of the nodes for J.
Ball as_printed(const Chart& chart, const Ball& area) {
  Ball sum = area;
  for (const Barycentric<Ball>& q : basis().nodes()) sum -= area_element(at_node(chart, q)) / Ball(6);
  return sum / Ball(4);
}

// The largest |1 - sum l_j| at the corners of sigma, exactly.
Rational largest_at_corners() {
  const InsetBasis<Rational> exact(1, Rational(1, 6));
  Rational largest = 0;
  std::vector<Rational> values(exact.size());
  for (const Barycentric<Rational>& corner : inset_nodes<Rational>(1, 0)) {
    exact.values(corner, std::span<Rational>(values));
    Rational rest = 1;
    for (const Rational& value : values) rest -= value;
    largest = std::max(largest, abs(rest));
  }
  return largest;
}

// 1/4 Int J (I - L) x over the octant.
Ball error_of_x(const Chart& octant) {
  Ball sum = Ball::pi() / Ball(4);
  for (const Barycentric<Ball>& q : basis().nodes()) sum -= Ball::pi() / Ball(6) * at_node(octant, q).point.x;
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
  const Ball octant = Ball::pi() / Ball(2);
  const Ball printed = as_printed(curved.charts[0], octant);
  Finding finding;
  finding.instead("a bound of |1/4 J (I - L) 1| over an octant of the sphere", zero,
                  octant / Ball(4) * Ball(largest_at_corners()));
  finding.instead("1/4 (I - L) J over a face of the octahedron", zero, as_printed(plane.charts[0], face));
  finding.require("1/4 (I - L) J over an octant of the sphere, as (35) has it", zero, printed);
  finding.instead("the same less (pi/2 - sqrt 2)/4", zero, printed - (octant - sqrt(Ball(2))) / Ball(4));
  finding.control("1/4 J (I - L) x over an octant of the sphere: u = x is not interpolated exactly", zero,
                  error_of_x(curved.charts[0]));
  finding.show(proved(printed));
  return finding;
}

}  // namespace radcert::verification::m06
