// SPDX-License-Identifier: GPL-3.0-or-later

// The mother functions.
//
// Checked      (12) "can be assumed to be zero for r > 4": G(4) = e^-8, and the share of the integral over
//              the plane beyond 4, which is e^-8 too, are below half a grey level of 255. Rejected for r > 3.
//              (13): K is the polynomial 2r^3 - 3r^2 + 1 on [0,1], which two polynomials of degree 3 that
//              agree at 5 points are; at r = 1 it and its derivative vanish, at 0 the derivative does: one
//              continuous derivative, as a function of the point too. Rejected: the second derivative, 6 at r
//              = 1 from the left, 0 from the right. K falls: K' = -6r(1 - r). "approximation of G": |K - G|
//              at r = 1, where K = 0, and for K(r/s) with s = 63/25, near the best scale. (14): whether the
//              three have a value at 0. Section V: a raw element "is zero (or nearly so)" beyond its radius.
// Not checked  whether e^-8 can be seen in an image.

#include <cmath>

#include "radcert/meshless/weights.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using ac98::proved;

AtMost half_a_grey_level() { return {.value = 1.0 / 510, .slack = 0, .why = "half a grey level of 255"}; }

Ball gaussian_at(const Rational& r) { return gaussian_bell(Ball(r)); }

/// The share of 2 pi Int G r dr beyond a radius.
Ball share_beyond(const Rational& radius) {
  return Ball(1) - plane_integral(gaussian_mother(radius)).value() /
                       plane_integral(gaussian_mother(std::nullopt)).value();
}

/// 2r^3 - 3r^2 + 1 and its first two derivatives.
Rational spline_polynomial(int derivative, const Rational& r) {
  switch (derivative) {
    case 0: return Rational(2) * r * r * r - Rational(3) * r * r + Rational(1);
    case 1: return Rational(6) * r * r - Rational(6) * r;
    default: return Rational(12) * r - Rational(6);
  }
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
  finding.require("G(4)", half_a_grey_level(), proved(gaussian_at(4)));
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
                    spline_bell(r) - spline_polynomial(0, r));
  }
  for (const int beyond : {1, 2})
    finding.require("K(" + std::to_string(beyond) + ")", IsExactly{0}, spline_bell(Rational(beyond)));
  finding.require("derivative at 0", IsExactly{0}, spline_polynomial(1, 0));
  finding.require("derivative at 1 from the left", IsExactly{0}, spline_polynomial(1, 1));
  finding.control("second derivative at 1 from the left", IsExactly{0}, spline_polynomial(2, 1));
  return finding;
}

Finding equation_13_approximation(const Bench&) {
  const BallPrecision precision(128);
  const AtMost tenth{.value = 0.1, .slack = 0, .why = "a tenth of the height of both"};
  Finding finding;
  finding.require("largest |K - G| over r = 0, 1/16, ..., 5", tenth, proved(largest_difference(1)));
  finding.control("the same with a support of 1/2", tenth, proved(largest_difference(Rational(1, 2))));
  finding.remark("the same for K(r/s), s = 63/25", proved(largest_difference(Rational(63, 25))));
  return finding;
}

Finding equation_14(const Bench&) {
  const auto without_value = [](const Ball& value) { return Rational(value.is_finite() ? 0 : 1); };
  Finding finding;
  finding.require("whether G(0) has no value", IsExactly{0}, without_value(gaussian_bell(Ball(0))));
  finding.require("whether K(0) has no value", IsExactly{0}, without_value(spline_bell(Ball(0))));
  finding.require("whether S(0) has no value", IsExactly{0}, without_value(inverse_square(Ball(0))));
  finding.control("whether 1/r has no value at 0", IsExactly{0}, without_value(Ball(1) / Ball(0)));
  return finding;
}

Finding section_5_support(const Bench&) {
  const BallPrecision precision(128);
  const AtMost nearly_zero{.value = 0.1, .slack = 0, .why = "a tenth of the height"};
  Finding finding;
  finding.require("K(1)", nearly_zero, proved(spline_bell(Ball(1))));
  finding.require("G(1)", nearly_zero, proved(gaussian_at(1)));
  finding.control("1 at r = 1", nearly_zero, proved(Ball(1)));
  finding.show(proved(gaussian_at(1)));
  return finding;
}

}  // namespace radcert::verification::psg10
