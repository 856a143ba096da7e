// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert {

/// A number in doubles with a bound or an estimate of its error.
/// Maths     |exact - value| <= radius
/// Source    -
/// Requires  finite value and radius, radius >= 0
/// Result    a sum takes its rounding up: if the terms enclose, so does it
/// Limits    whether the radius is proved is known to whoever made it
struct Estimate {
  double value = 0;
  double radius = 0;

  Estimate& operator+=(const Estimate& other);
};

/// The sum of two numbers with radii; see Estimate.
/// Maths     |a + b - value| <= radius_a + radius_b + 2^-53 |value|
/// Source    IEEE 754: the nearest double is within half a unit
/// Requires  -
/// Result    the radius is rounded up: two additions and a product, each within 2^-53, are covered by 1 +
///           2^-51
/// Limits    -
[[nodiscard]] inline Estimate operator+(const Estimate& a, const Estimate& b) {
  constexpr double half_unit = 0x1p-53;
  constexpr double upwards = 1 + 0x1p-51;
  const double value = a.value + b.value;
  const double size = value < 0 ? -value : value;
  return {value, (a.radius + b.radius + half_unit * size) * upwards};
}
inline Estimate& Estimate::operator+=(const Estimate& other) { return *this = *this + other; }

/// A ball as a double with a radius, which encloses it; ContractViolation with the failure of a failed ball.
[[nodiscard]] Estimate enclosing_estimate(const Ball& ball);
/// All that a number with its radius may be.
[[nodiscard]] Ball enclosing_ball(const Estimate& estimate);

}  // namespace radcert
