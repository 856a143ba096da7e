// SPDX-License-Identifier: GPL-3.0-or-later

// A point light in the place of an element.
//
// Checked      An element K(u/alpha) on a plane, and a site above its centroid at the distance 1, facing it:
//              2 pi Int K(u/alpha) u /(pi (1 + u^2)^2) du, its light there, over w = 3 pi/10 alpha^2 times
//              1/pi, that of a point light of the same integral, in balls. The quotient tends to 1 like
//              alpha^2: its difference from 1 falls by 4 as alpha goes from 1/4 to 1/8 and 1/16, to within
//              the next term, with exponents in [3/2, 5/2]. Rejected: an element as wide as its distance, as
//              in a corner however close the sites are, with the exponent 0.
// Not checked  other places and slopes, of which the error has the same order, by Taylor's formula for the
//              kernel, as an element that is even about its centroid has no first moments.

#include <string>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/meshless/weights.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
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
  const Ball of_element = Ball(2) * ac98::known(integral_on_interval(line_function(light), Ball(0),
                                                                     Ball(alpha), {.radius = 1e-24}));
  const Ball weight = plane_integral(spline_mother()).value() * Ball(alpha * alpha);
  return Ball(1) - of_element * Ball::pi() * Ball(distance * distance) / weight;
}

/// The exponent with which a number falls when alpha is halved.
Ball exponent(const Ball& coarse, const Ball& fine) { return log(coarse / fine) / log(Ball(2)); }

}  // namespace

Finding section_7_point_light(const Bench&) {
  const BallPrecision precision(160);
  const LiesIn two{.least = Rational(3, 2), .largest = Rational(5, 2)};
  Finding finding;
  for (const long n : {4L, 8L})
    finding.require("exponent of the error of a point light, alpha from 1/" + std::to_string(n) + " to 1/" +
                        std::to_string(2 * n) + " of the distance",
                    two, exponent(defect(Rational(1, n), 1), defect(Rational(1, 2 * n), 1)));
  finding.control("the same, alpha and the distance from 1/4 to 1/8", two,
                  exponent(defect(Rational(1, 4), Rational(1, 4)), defect(Rational(1, 8), Rational(1, 8))));
  return finding;
}

}  // namespace radcert::verification::psg10
