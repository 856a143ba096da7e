// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "radcert/scalar/ball.h"

namespace radcert {

/// A number as it was computed, a radius, and whether the radius is proved.
/// Maths     |exact - value| <= radius: a theorem if guaranteed, an estimate if not
/// Result    a sum is guaranteed if both of its terms are, and its radius holds the rounding of the sum
/// Limits    an infinite radius says nothing about the error
struct Approximation {
  double value = 0;
  double radius = std::numeric_limits<double>::infinity();
  bool guaranteed = false;

  [[nodiscard]] static constexpr Approximation exact(double value) { return {value, 0, true}; }
  [[nodiscard]] static constexpr Approximation proved(double value, double radius) {
    return {value, radius, true};
  }
  [[nodiscard]] static constexpr Approximation estimated(double value, double radius) {
    return {value, radius, false};
  }
  /// Without any statement about its error.
  [[nodiscard]] static constexpr Approximation without_radius(double value) {
    return {value, std::numeric_limits<double>::infinity(), false};
  }

  [[nodiscard]] bool has_radius() const { return radius < std::numeric_limits<double>::infinity(); }

  Approximation& operator+=(const Approximation& other);
  [[nodiscard]] Approximation operator-() const { return {-value, radius, guaranteed}; }
};

/// The sum of two numbers with radii.
/// Maths     |a + b - value| <= radius_a + radius_b + 2^-53 |value|
/// Source    IEEE 754: the nearest double is within half a unit
/// Result    the radius is rounded up: two additions and a product, each within 2^-53, are covered by 1 +
///           2^-51
[[nodiscard]] inline Approximation operator+(const Approximation& a, const Approximation& b) {
  constexpr double half_unit = 0x1p-53;
  constexpr double upwards = 1 + 0x1p-51;
  const double value = a.value + b.value;
  return {value, (a.radius + b.radius + half_unit * std::abs(value)) * upwards, a.guaranteed && b.guaranteed};
}
inline Approximation& Approximation::operator+=(const Approximation& other) { return *this = *this + other; }

/// A ball as a double with a proved radius.
/// Maths     |x - value| <= radius for every x of the ball
/// Requires  a finite ball whose midpoint is within the range of double, else ContractViolation
/// Result    value is the midpoint to the nearest; the radius is rounded up
[[nodiscard]] Approximation enclosing(const Ball& ball);

/// All that a number with its radius may be.
/// Requires  finite value and radius
[[nodiscard]] Ball ball_of(const Approximation& number);

/// The largest absolute value of numbers with radii.
/// Maths     max_i |x_i|: between max_i (|value_i| - radius_i) and max_i (|value_i| + radius_i)
/// Requires  finite values and radii
/// Result    contains the maximum, guaranteed if all numbers are; half the width of the bounds is at most the
///           largest radius
[[nodiscard]] Approximation max_abs(std::span<const Approximation> numbers);

}  // namespace radcert
