// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      On all ellipsoids, for all P: 0 <= G <= c, the c of (6), and the area of T is at most 2 pi
//              epsilon^2 for 0 < epsilon <= a^2/(3 c), a the shortest half axis and c the longest, by
//              identities: ellipsoids.h. Besides at the tip of the ellipsoid (1,2,5) for all 0 < epsilon <= 1
//              at once: 0 <= Int_T G, and Int_T G <= c area(T) up to 1/10, with the least c, 25/4, and the
//              area of T's shadow on the tangent plane, which is less than that of T; on the sphere, where
//              Int_T G is pi epsilon^2/4, for three. The order 2 is not 3: Int_T G/epsilon^2 has a positive
//              limit.
// Not checked  other surfaces.

#include "verification/claims/ac98/convex_bodies/ellipsoids.h"
#include "verification/claims/ac98/surfaces/excluded_ball.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding equation_10(const Bench& bench) {
  const long panels = bench.budget == Budget::quick ? 512 : 4096;
  const BallPrecision precision(128);
  Finding finding;
  require_small_balls_on_ellipsoids(finding);
  const Rational kernel_bound(25, 4);
  const EllipsoidTip tip(1, 2, 5);
  const Ball cap = tip.cap_over_square(1, panels);
  const Ball shadow = tip.shadow_over_square(1, panels);
  finding.require("-Int_T G/epsilon^2, all epsilon up to 1, ellipsoid (1,2,5)", AtMost{}, proved(-cap));
  finding.require("(Int_T G - 25/4 area of the shadow of T)/epsilon^2, all epsilon up to 1/10", AtMost{},
                  proved(tip.cap_over_square(Rational(1, 10), panels) -
                         Ball(kernel_bound) * tip.shadow_over_square(Rational(1, 10), panels)));
  finding.control("the same with the c of (6) of the unit sphere, 1/4", AtMost{},
                  proved(tip.cap_over_square(Rational(1, 10), panels) -
                         Ball(Rational(1, 4)) * tip.shadow_over_square(Rational(1, 10), panels)));
  finding.require("Int_T G/epsilon^2 - 10, all epsilon up to 1, ellipsoid (1,2,5)", AtMost{},
                  proved(cap - Ball(10)));
  finding.remark("area of the shadow of T/epsilon^2, all epsilon up to 1", proved(shadow));
  const EllipsoidTip sphere(1, 1, 1);
  for (const Rational& radius : {Rational(1), Rational(1, 10), Rational(1, 1000)}) {
    constexpr double error = 1e-32;
    const std::string at = ", sphere, epsilon = " + radius.to_text();
    const Ball square(radius * radius);
    const AgreesWith quarter{.value = Ball::pi() / Ball(4), .within = 1e-22};
    finding.require("Int_T G/epsilon^2, against pi/4" + at, quarter, sphere.over_cap(radius, error) / square);
    finding.control("Int_T G/epsilon^2 at the tip of the ellipsoid (1,2,5), against pi/4" + at, quarter,
                    tip.over_cap(radius, error) / square);
  }
  // (c^2/8) Int k^2 dphi, k = cos^2 + sin^2/4 the curvature over c: Int = pi (3/4 (1 + 1/16) + 1/2 1/4).
  const Rational limit = Rational(25, 8) * (Rational(3, 4) * Rational(17, 16) + Rational(1, 8));
  const Rational small(1, 1000000);
  const AgreesWith leading{.value = Ball::pi() * Ball(limit), .within = 1e-8};
  finding.require("Int_T G/epsilon^2 at epsilon = 1e-6, ellipsoid (1,2,5), against its limit", leading,
                  tip.over_cap(small, 1e-32) / Ball(small * small));
  finding.control("Int_T G/epsilon^2 at epsilon = 1, against that limit", leading, tip.over_cap(1, 1e-32));
  finding.show(proved(Ball::pi() * Ball(limit)));
  return finding;
}

}  // namespace radcert::verification::ac98
