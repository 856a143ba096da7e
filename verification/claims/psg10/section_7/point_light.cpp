// SPDX-License-Identifier: GPL-3.0-or-later

// A point light in the place of an element.
//
// Checked      An element K(u/alpha) on a plane, and a site above its centroid at the distance 1, facing it:
//              2 pi Int K(u/alpha) u /(pi (1 + u^2)^2) du, its light there, over w = 3 pi/10 alpha^2 times
//              1/pi, that of a point light of the same integral, in balls. The quotient tends to 1 like
//              alpha^2: 1 less it is between (10/21) alpha^2 - (5/18) alpha^4 and (10/21) alpha^2, at alpha =
//              1/4, 1/8 and 1/16. Rejected: an element as wide as its distance, as in a corner however close
//              the sites are.
// Not checked  other places and slopes, of which the error has the same order, by Taylor's formula for the
//              kernel, as an element that is even about its centroid has no first moments.

#include <string>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/meshless/weights.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

/// 1 less the quotient of the light of an element and that of a point light, at a distance.
Ball defect(const Rational& alpha, const Rational& distance) {
  const auto light = [alpha, distance](const auto& u) {
    using R = std::decay_t<decltype(u)>;
    const R x = u / R(alpha);
    const R square = u * u + R(distance * distance);
    return R((R(2) * x * x * x - R(3) * x * x + R(1)) * u * R(distance * distance) / (square * square));
  };
  const Ball of_element =
      Ball(2) * known(integral_on_interval(line_function(light), Ball(0), Ball(alpha), {.radius = 1e-24}));
  const Ball weight = plane_integral(spline_mother()).value() * Ball(alpha * alpha);
  return Ball(1) - of_element * Ball::pi() * Ball(distance * distance) / weight;
}

/// Its bounds, a = alpha/distance. With t = (u/distance)^2, 1 - 2t <= (1 + t)^-2 <= 1 - 2t + 3t^2, as 1 - (1
/// + t)^2 (1 - 2t) = 3t^2 + 2t^3 and (1 + t)^2 (1 - 2t + 3t^2) - 1 = 4t^3 + 3t^4, and the means of t and t^2
/// by K(u/alpha) u du are (5/21) a^2 and (5/54) a^4.
LiesIn bounds(const Rational& a) {
  const Rational first = Rational(10, 21) * a * a;
  return {.least = first - Rational(5, 18) * a * a * a * a, .largest = first};
}

}  // namespace

Finding section_7_point_light(const Bench&) {
  const BallPrecision precision(160);
  Finding finding;
  for (const long n : {4L, 8L, 16L})
    finding.require("what the light of an element is short of a point light's, alpha = 1/" +
                        std::to_string(n) + " of the distance",
                    bounds(Rational(1, n)), defect(Rational(1, n), 1));
  finding.control("the same, alpha as large as the distance", bounds(Rational(1, 4)), defect(1, 1));
  return finding;
}

}  // namespace radcert::verification::psg10
