// SPDX-License-Identifier: GPL-3.0-or-later

// Where S is curved, U_e is not a hemisphere: its rim has w_3 = cos theta_P, which (5) bounds by c e. The
// integrand of (11) is w_3 itself, so that what is missing is Int (cos theta_P)^2/2 dphi <= pi c^2 e^2, for
// every surface with (5) and every e for which a ray of U_e meets the rim once: the printed o(e) is right,
// and O(e^2) is what holds.
//
// Checked      (11): G = n_P . (Q-P)/|P-Q|^3 with the normal of the sphere around P, for all Q and n_P. (12)
//              on all ellipsoids, for all P and all e, which rays need not meet the rim once for: 0 <= pi -
//              Int_U G <= pi c^2 e^2, c the constant of (5), by identities: ellipsoids.h. Besides at the tip
//              of the ellipsoid (1,2,5), where the curvatures differ most, for all 0 < e <= 1 at
//              once: 0 <= (pi - Int_U G)/e^2 <= pi c^2, c = 5/2 the least constant of (5); the limit of this
//              quotient; on the sphere, where it is pi/4, the constant of (5) being 1/2.
// Not checked  surfaces that are no more than C^1 at P.

#include <array>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/ac98/convex_bodies/ellipsoids.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/excluded_ball.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Points Q = P + w of U, |w| = epsilon, where epsilon^3 G is not so many times n_P.w. The normal is
// -w/epsilon, so that epsilon^3 G is |w|^2 times the kernel for -w in its place: rational functions of w of
// degree 4 at most, and linear in n_P, for which the axes are enough.
Rational differing_on_the_sphere_around(const Rational& multiple) {
  const std::array<Vector<Rational>, 3> axes{Vector<Rational>{1, 0, 0}, Vector<Rational>{0, 1, 0},
                                             Vector<Rational>{0, 0, 1}};
  using Three = std::array<Rational, 3>;
  constexpr long values = 5;
  Rational count = 0;
  for (const Vector<Rational>& n_p : axes)
    count += differing_on_grid<3>(
        values,
        [&](const Three& x) {
          // -w for the normal -w/epsilon: epsilon G.
          const Vector<Rational> w{x[0], x[1], x[2]};
          return geometric_kernel<Rational>({0, 0, 0}, n_p, w, -w) * dot(w, w);
        },
        [&](const Three& x) {
          return multiple * dot(n_p, Vector<Rational>{x[0], x[1], x[2]});
        });
  return count;
}

}  // namespace

Finding equation_12(const Bench& bench) {
  const long panels = bench.budget == Budget::quick ? 512 : 4096;
  const BallPrecision precision(192);
  constexpr double error = 1e-32;
  Finding finding;
  finding.require("(11): points of U where G differs from n_P . (Q-P)/|P-Q|^3", IsExactly{0},
                  differing_on_the_sphere_around(1));
  finding.control("points of U where -G does", IsExactly{0}, differing_on_the_sphere_around(-1));
  require_small_balls_on_ellipsoids(finding);
  const EllipsoidTip tip(1, 2, 5);
  const EllipsoidTip other(1, 2, 3);
  const EllipsoidTip sphere(1, 1, 1);
  const Ball lack = tip.lack_over_square(1, panels);
  const Ball bound = Ball::pi() * Ball(Rational(25, 4));
  finding.require("(Int_U G - pi)/epsilon^2, all epsilon up to 1, ellipsoid (1,2,5)", AtMost{},
                  proved(-lack));
  finding.require("(pi - Int_U G)/epsilon^2 - pi c^2, all epsilon up to 1, ellipsoid (1,2,5)", AtMost{},
                  proved(lack - bound));
  const Rational small(1, 1000000);
  const auto quotient = [&](const EllipsoidTip& at, const Rational& radius) {
    return (Ball::pi() - at.over_sphere(radius, error)) / Ball(radius * radius);
  };
  finding.control(
      "(pi - Int_U G)/epsilon^2 - pi c^2, c = 1/2 of the unit sphere, epsilon = 1e-6, ellipsoid (1,2,5)",
      AtMost{}, proved(quotient(tip, small) - Ball::pi() / Ball(4)));
  for (const Rational& radius : {Rational(1), Rational(1, 10), Rational(1, 1000), small}) {
    const std::string at = ", epsilon = " + radius.to_text();
    const AgreesWith quarter{.value = Ball::pi() / Ball(4), .within = 1e-15};
    finding.require("(pi - Int_U G)/epsilon^2, sphere" + at, quarter, quotient(sphere, radius));
    finding.control("(pi - Int_U G)/epsilon^2, ellipsoid (1,2,3)" + at, quarter, quotient(other, radius));
  }
  const Rational limit = Rational(25, 8) * (Rational(3, 4) * Rational(17, 16) + Rational(1, 8));
  const AgreesWith leading{.value = Ball::pi() * Ball(limit), .within = 1e-8};
  finding.require("(pi - Int_U G)/epsilon^2 at epsilon = 1e-6, ellipsoid (1,2,5), against its limit", leading,
                  quotient(tip, small));
  finding.control("the same at epsilon = 1", leading, quotient(tip, 1));
  finding.show(proved(quotient(tip, small)));
  return finding;
}

}  // namespace radcert::verification::ac98
