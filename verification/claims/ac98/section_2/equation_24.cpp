// SPDX-License-Identifier: GPL-3.0-or-later

// With D = s^2 + eta^2 + z^2, s = xi - x, w^2 = 1 + z^2: -z eta/(2D) has the derivative z eta^2/D^2 - z/(2D)
// by eta; it is 0 at eta = 0 and -z/(2 (s^2 + w^2)) at eta = 1, which has the antiderivative -z/(2w)
// atan(s/w) by s. The ends s = -x and s = 1 - x give (24).
//
// Checked      For all x and z of 0 < x, z < 1 at once: the derivative, and the value at eta = 1 against the
//              antiderivative's, as identities of rational functions, with the derivative of atan(s/c)/c
//              known to be 1/(c^2 + s^2). Degrees: 4 at most in each variable, over D^2. Beside that
//              enclosures of both double integrals, at points and on boxes, for the formula as printed and
//              for the library's closed form, Clausen's integral included.
// Not checked  nothing is left out.

#include "radcert/closed_form/two_squares.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/printed_integral.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// (24) without its last integral.
Ball printed_part(const Ball& x, const Ball& z) {
  const Ball w = sqrt(Ball(1) + z * z);
  return -z / (Ball(2) * w) * (atan(x / w) + atan((Ball(1) - x) / w));
}

Ball last_integral(const Ball& x, const Ball& z) { return TwoSquares<Ball>(x, z).inverse_square(); }

template <class R>
R inner(const R& s, const R& eta, const R& z) {
  return -z * eta / (R(2) * (s * s + eta * eta + z * z));
}

Rational squared_distance(const Rational& s, const Rational& eta, const Rational& z) {
  return s * s + eta * eta + z * z;
}

Rational inner_slope(const Rational& s, const Rational& eta, const Rational& z) {
  return inner(Dual<Rational>(s), Dual<Rational>(eta, 1, 0), Dual<Rational>(z)).by_s;
}

// z eta^2/D^2 less z/D times a factor.
auto difference_with(const Rational& factor) {
  return [factor](const Rational& s, const Rational& eta, const Rational& z) {
    const Rational d = squared_distance(s, eta, z);
    return z * eta * eta / (d * d) - factor * z / d;
  };
}

}  // namespace

Finding equation_24(const Bench& bench) {
  Finding finding;
  finding.require("points where d/deta (-z eta/(2D)) differs from z eta^2/D^2 - z/(2D)", IsExactly{0},
                  differing_points(inner_slope, difference_with(Rational(1, 2))));
  finding.control("points where d/deta (-z eta/(2D)) differs from z eta^2/D^2 - z/D", IsExactly{0},
                  differing_points(inner_slope, difference_with(1)));
  finding.require("points where -z eta/(2D) at eta = 1 differs from d/ds [-z/(2w) atan(s/w)]", IsExactly{0},
                  differing_points([](const Rational& s, const Rational&,
                                      const Rational& z) { return inner(s, Rational(1), z); },
                                   [](const Rational& s, const Rational&, const Rational& z) {
                                     return -z / (2 * (s * s + 1 + z * z));
                                   }));
  finding.require(
      "points where -z eta/(2D) at eta = 0 differs from 0", IsExactly{0},
      differing_points(
          [](const Rational& s, const Rational&, const Rational& z) { return inner(s, Rational(0), z); },
          [](const Rational&, const Rational&, const Rational&) { return Rational(0); }));
  require_values(finding, bench,
                 {.name = "last integral of (24)",
                  .integral = &UnitSquareIntegrals::inverse_square,
                  .printed = last_integral,
                  .library = last_integral,
                  .wrong = [](const Ball& x, const Ball& z) { return last_integral(x, z) / Ball(2); },
                  .mistake = "half the closed form"});
  require_values(
      finding, bench,
      {.name = "(24)",
       .integral = &UnitSquareIntegrals::distance,
       .printed = [](const Ball& x,
                     const Ball& z) { return printed_part(x, z) + last_integral(x, z) / Ball(2); },
       .library = [](const Ball& x, const Ball& z) { return TwoSquares<Ball>(x, z).distance(); },
       .wrong = [](const Ball& x, const Ball& z) { return printed_part(x, z) + last_integral(x, z); },
       .mistake = "its last integral not halved"});
  return finding;
}

}  // namespace radcert::verification::ac98
