// SPDX-License-Identifier: GPL-3.0-or-later

// The mother functions.
//
// Checked      (12) "can be assumed to be zero for r > 4": G on [4, 16], beyond which it falls on, and the
//              share of the integral over the plane beyond 4, which is e^-8 too, are below half a grey level
//              of 255. Rejected for r > 3. (13): K is the polynomial 2r^3 - 3r^2 + 1 on [0,1], which two
//              polynomials of degree 3 that agree at 5 points are; at r = 1 it vanishes, and so does its
//              derivative from the left, by differences that are exact at degree 3; at 0 the derivative does:
//              one continuous derivative, as a function of the point too. Rejected: 1 - r. "approximation of
//              G": |K - G| at r = 0, 1/16, ..., 5, largest at r = 7/8; what holds: K(r/s) with s =
//              1261/500, near the best scale, enclosed for all r. (14): whether the three have a value at 0;
//              a number or, as section VI has it, +infinity as well; rejected: r^2 log r as it stands.
//              Section V: a raw element "is zero (or nearly so)" beyond its radius: K on [1 + 2^-20, 1000]
//              is, G on [1, 2] is above a tenth everywhere; rejected: (16) with its distance as if that had a
//              radius.
// Not checked  whether e^-8 can be seen in an image.

#include <algorithm>
#include <cmath>

#include "radcert/meshless/weights.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

AtMost half_a_grey_level() { return {.value = 1.0 / 510, .slack = 0, .why = "half a grey level of 255"}; }

Ball gaussian_at(const Rational& r) { return gaussian_bell(Ball(r)); }

/// The share of 2 pi Int G r dr beyond a radius.
Ball share_beyond(const Rational& radius) {
  return Ball(1) - plane_integral(gaussian_mother(radius)).value() /
                       plane_integral(gaussian_mother(std::nullopt)).value();
}

/// 2r^3 - 3r^2 + 1.
Rational spline_polynomial(const Rational& r) {
  return Rational(2) * r * r * r - Rational(3) * r * r + Rational(1);
}

/// The derivative at an end of [0,1], of a function that is a polynomial of degree 3 there: by its values at
/// the distances 0, 1/4, 1/2 and 3/4 from that end, exactly.
template <class Function>
Rational slope_at_end(const Function& function, int end) {
  const auto at = [&](long quarters) {
    return function(end == 0 ? Rational(quarters, 4) : Rational(4 - quarters, 4));
  };
  const Rational inwards =
      (Rational(-11) * at(0) + Rational(18) * at(1) - Rational(9) * at(2) + Rational(2) * at(3)) *
      Rational(4, 6);
  return end == 0 ? inwards : -inwards;
}

/// A bound from above of |K(r/s) - G(r)| for all r >= 0: cells of [0,5], and G(5) beyond, where K is 0 for s
/// <= 5.
Ball largest_anywhere(const Rational& scale) {
  constexpr long cells_a_unit = 512;
  Ball largest = gaussian_at(5);
  for (long k = 0; k < 5 * cells_a_unit; ++k) {
    const Ball r = hull(Ball(Rational(k, cells_a_unit)), Ball(Rational(k + 1, cells_a_unit)));
    largest = max(largest, abs(spline_bell(Ball(r / Ball(scale))) - gaussian_bell(r)));
  }
  return largest;
}

/// A bound from below of max |K(r/s) - G(r)|: the largest over r = 0, 1/16, ..., 5.
Ball largest_difference(const Rational& scale) {
  Ball largest(0);
  for (int k = 0; k <= 80; ++k) {
    const Rational r(k, 16);
    largest = max(largest, abs(Ball(spline_bell(Rational(r / scale))) - gaussian_at(r)));
  }
  return largest;
}

}  // namespace

Finding equation_12(const Bench&) {
  const BallPrecision precision(128);
  Finding finding;
  finding.require("G for all r from 4 to 16", half_a_grey_level(),
                  proved(gaussian_bell(hull(Ball(4), Ball(16)))));
  finding.control("G(3)", half_a_grey_level(), proved(gaussian_at(3)));
  finding.require("share of the integral beyond r = 4", half_a_grey_level(), proved(share_beyond(4)));
  finding.control("share of the integral beyond r = 3", half_a_grey_level(), proved(share_beyond(3)));
  finding.show(proved(gaussian_at(4)));
  return finding;
}

Finding equation_13(const Bench&) {
  Finding finding;
  for (int k = 0; k <= 4; ++k) {
    const Rational r(k, 4);
    finding.require("K less the polynomial, r = " + r.to_text(), IsExactly{0},
                    spline_bell(r) - spline_polynomial(r));
  }
  for (const int beyond : {1, 2})
    finding.require("K(" + std::to_string(beyond) + ")", IsExactly{0}, spline_bell(Rational(beyond)));
  const auto spline = [](const Rational& r) { return spline_bell(r); };
  const auto tent = [](const Rational& r) { return Rational(Rational(1) - r); };
  finding.require("derivative at 0", IsExactly{0}, slope_at_end(spline, 0));
  finding.require("derivative at 1 from the left", IsExactly{0}, slope_at_end(spline, 1));
  finding.control("derivative at 1 from the left, 1 - r", IsExactly{0}, slope_at_end(tent, 1));
  return finding;
}

Finding equation_13_approximation(const Bench&) {
  const BallPrecision precision(128);
  const AtMost tenth{.value = 0.1, .slack = 0, .why = "a tenth of the height of both"};
  Finding finding;
  finding.require("largest |K - G| over r = 0, 1/16, ..., 5", tenth, proved(largest_difference(1)));
  finding.control("the same with a support of 1/2", tenth, proved(largest_difference(Rational(1, 2))));
  const Rational best(1261, 500);
  finding.instead("|K(r/s) - G(r)| for all r, s = 2.522", tenth, proved(largest_anywhere(best)));
  finding.remark("the largest of |K(r/s) - G(r)| over r = 0, 1/16, ..., 5, s = 2.522",
                 proved(largest_difference(best)));
  return finding;
}

Finding equation_14(const Bench&) {
  // To the letter, a number; or, as section VI has it, a number or +infinity, whose reciprocal is 0.
  const auto without_number = [](const Ball& value) { return value.is_finite() ? 0.0 : 1.0; };
  const auto without_value = [&](const Ball& value, const Ball& reciprocal_value) {
    const double to_the_letter = without_number(value);
    const double extended = std::min(to_the_letter, without_number(reciprocal_value));
    return Approximation::proved((to_the_letter + extended) / 2, (to_the_letter - extended) / 2);
  };
  const Equals none{.value = 0, .slack = 0, .why = "each function has a value at 0"};
  const Ball zero(0);
  Finding finding;
  finding.require("whether G(0) has no value", none,
                  without_value(gaussian_bell(zero), Ball(1) / gaussian_bell(zero)));
  finding.require("whether K(0) has no value", none,
                  without_value(spline_bell(zero), Ball(1) / spline_bell(zero)));
  finding.require("whether S(0) has no value, to the letter or with +infinity for one", none,
                  without_value(inverse_square(zero), zero * zero));
  const auto thin_plate = [](const Ball& r) { return r * r * log(r); };
  finding.control("whether r^2 log r has no value at 0", none,
                  without_value(thin_plate(zero), Ball(1) / thin_plate(zero)));
  return finding;
}

Finding section_5_support(const Bench&) {
  const BallPrecision precision(128);
  const AtMost nearly_zero{.value = 0.1, .slack = 0, .why = "a tenth of the height"};
  Finding finding;
  finding.require("K for all r from 1 + 2^-20 to 1000", nearly_zero,
                  proved(spline_bell(hull(Ball(1) + Ball(Rational(1, 1 << 20)), Ball(1000)))));
  finding.require("G for all r from 1 to 2", nearly_zero, proved(gaussian_bell(hull(Ball(1), Ball(2)))));
  finding.control("S(2), which has no radius", nearly_zero, proved(inverse_square(Ball(2))));
  finding.remark("G(1)", proved(gaussian_at(1)));
  finding.show(proved(gaussian_at(2)));
  return finding;
}

}  // namespace radcert::verification::psg10
