// SPDX-License-Identifier: GPL-3.0-or-later

// With D = s^2 + eta^2 + z^2, s = xi - x, w^2 = 1 + z^2: -z/(2D) is an antiderivative of z eta/D^2 by eta,
// and (1/2) atan(s/z) - z/(2w) atan(s/w) one of its difference between eta = 1 and eta = 0, by s. With
// atan(x/z) = pi/2 - atan(z/x) for x, z > 0 the ends s = -x and s = 1 - x give (22).
//
// Checked      For all x and z of 0 < x, z < 1 at once: both antiderivatives, and the derivative of (22) by x
//              against that of the integral between these ends, as identities of rational functions, with the
//              derivative of atan(s/c)/c known to be 1/(c^2 + s^2). Degrees: 4 at most in each variable, over
//              D^2 and (s^2 + z^2)(s^2 + w^2). Beside that the formula typed in as printed, and the
//              library's, against enclosures of the double integral that know no antiderivative: at points,
//              and on boxes.
// Not checked  the remark that the edges x = 0 and x = 1 may cause problems: the limit at a corner depends on
// the direction, see
//              closed_form/two_squares.h.

#include "radcert/closed_form/two_squares.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/printed_integral.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// (22) with a factor before its second part.
Ball printed(const Ball& x, const Ball& z, long factor) {
  const Ball w = sqrt(Ball(1) + z * z);
  const Ball first = (Ball::pi() - atan(z / x) - atan(z / (Ball(1) - x))) / Ball(2);
  return first - Ball(factor) * z / (Ball(2) * w) * (atan(x / w) + atan((Ball(1) - x) / w));
}

template <class R>
R inner(const R& s, const R& eta, const R& z) {
  return -z / (R(2) * (s * s + eta * eta + z * z));
}

Rational kernel(const Rational& s, const Rational& eta, const Rational& z) {
  const Rational d = s * s + eta * eta + z * z;
  return z * eta / (d * d);
}

Rational inner_slope(const Rational& s, const Rational& eta, const Rational& z) {
  return inner(Dual<Rational>(s), Dual<Rational>(eta, 1, 0), Dual<Rational>(z)).by_s;
}

Rational between_the_ends(const Rational& s, const Rational&, const Rational& z) {
  return inner(s, Rational(1), z) - inner(s, Rational(0), z);
}

Rational outer_slope(const Rational& s, const Rational& z, const Rational& sign) {
  const Rational w_squared = 1 + z * z;
  return z / (2 * (z * z + s * s)) + sign * z / (2 * (w_squared + s * s));
}

}  // namespace

Finding equation_22(const Bench& bench) {
  Finding finding;
  finding.require("points where d/deta (-z/(2D)) differs from z eta/D^2", IsExactly{0},
                  differing_points(inner_slope, kernel));
  finding.require("points where d/ds [atan(s/z)/2 - z/(2w) atan(s/w)] differs from -z/(2D) between the ends",
                  IsExactly{0},
                  differing_points([](const Rational& s, const Rational&,
                                      const Rational& z) { return outer_slope(s, z, -1); },
                                   between_the_ends));
  finding.control("points where d/ds [atan(s/z)/2 + z/(2w) atan(s/w)] differs from it", IsExactly{0},
                  differing_points([](const Rational& s, const Rational&,
                                      const Rational& z) { return outer_slope(s, z, 1); },
                                   between_the_ends));
  // The ends: the integral from s = -x to 1 - x has the derivative g(-x) - g(1-x) by x; the arctangents of
  // (22) have the derivatives by x that stand here. x + 2 is in place of x: the grid's first variable is -3/4
  // at least.
  const auto ends = [](const Rational& s, const Rational& eta, const Rational& z) {
    const Rational x = s + 2;
    return between_the_ends(-x, eta, z) - between_the_ends(1 - x, eta, z);
  };
  const auto printed_by_x = [](const Rational& sign) {
    return [sign](const Rational& s, const Rational&, const Rational& z) {
      const Rational x = s + 2;
      const Rational a = 1 - x;
      const Rational w_squared = 1 + z * z;
      return (z / (x * x + z * z) + sign * z / (a * a + z * z)) / 2 -
             z / 2 * (1 / (w_squared + x * x) + sign / (w_squared + a * a));
    };
  };
  finding.require("points where the derivative of (22) by x differs from that of the integral", IsExactly{0},
                  differing_points(ends, printed_by_x(-1)));
  finding.control("points where it differs with atan(z/(1-x)) subtracted", IsExactly{0},
                  differing_points(ends, printed_by_x(1)));
  require_values(finding, bench,
                 {.name = "(22)",
                  .integral = &UnitSquareIntegrals::one,
                  .printed = [](const Ball& x, const Ball& z) { return printed(x, z, 1); },
                  .library = [](const Ball& x, const Ball& z) { return TwoSquares<Ball>(x, z).one(); },
                  .wrong = [](const Ball& x, const Ball& z) { return printed(x, z, 2); },
                  .mistake = "z/sqrt(1+z^2) for z/(2 sqrt(1+z^2))"});
  return finding;
}

}  // namespace radcert::verification::ac98
