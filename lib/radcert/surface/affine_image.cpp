// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/affine_image.h"

namespace radcert {
namespace {

/// The value of a sum of powers at one of the corners of the unit square.
Rational at_corner(const PowerSum& sum, bool s, bool t) {
  Rational value = 0;
  for (const auto& [exponents, coefficient] : sum)
    if ((s || exponents[0].sign() == 0) && (t || exponents[1].sign() == 0)) value += coefficient;
  return value;
}

std::optional<Vector<Rational>> exact_corner(const Vector<ExactFunction>& image, bool s, bool t) {
  Vector<Rational> point;
  const auto coordinate = [&](const ExactFunction& f, Rational& value) {
    const std::optional<PowerQuotient> quotient = f.quotient();
    if (!f.is_known() || !quotient) return false;
    const Rational denominator = at_corner(quotient->denominator, s, t);
    if (denominator.sign() == 0) return false;
    value = at_corner(quotient->numerator, s, t) / denominator;
    return true;
  };
  if (!coordinate(image.x, point.x) || !coordinate(image.y, point.y) || !coordinate(image.z, point.z))
    return std::nullopt;
  return point;
}

}  // namespace

std::optional<AffineImage> affine_image(const Vector<ExactFunction>& image) {
  const std::optional<Vector<Rational>> origin = exact_corner(image, false, false);
  const std::optional<Vector<Rational>> along_s = exact_corner(image, true, false);
  const std::optional<Vector<Rational>> along_t = exact_corner(image, false, true);
  if (!origin || !along_s || !along_t) return std::nullopt;
  return AffineImage{.origin = *origin, .first = *along_s - *origin, .second = *along_t - *origin};
}

}  // namespace radcert
