// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/scalar/ball.h"
#include "radcert/study/result.h"

namespace radcert {

/// A double and a bound of its distance from a number.
struct EnclosedNumber {
  double value = 0;
  double radius = 0;
};

/// A ball as a double with a radius.
/// Maths     |x - value| <= radius for every x of the ball
/// Source    -
/// Requires  a finite ball whose midpoint is within the range of double, else ContractViolation
/// Result    value is the midpoint to the nearest; the radius is rounded up
/// Limits    -
inline EnclosedNumber enclosed_number(const Ball& ball) {
  const double value = ball.to_double();
  return {.value = value, .radius = abs(ball - Ball(value)).upper_double()};
}

/// The ball of such a number.
inline Ball ball_of(const EnclosedNumber& number) { return widened(Ball(number.value), Ball(number.radius)); }

/// The largest size of enclosed numbers.
/// Maths     max_i |x_i|: between max_i (|value_i| - radius_i) and max_i (|value_i| + radius_i)
/// Source    -
/// Requires  finite numbers
/// Result    a guaranteed figure that contains the maximum
/// Limits    half the width of the bounds is at most the largest radius
inline Figure largest_size(std::span<const EnclosedNumber> numbers) {
  Ball least = 0;
  Ball most = 0;
  for (const EnclosedNumber& number : numbers) {
    const Ball size = abs(Ball(number.value));
    least = max(least, size - Ball(number.radius));
    most = max(most, size + Ball(number.radius));
  }
  const EnclosedNumber both = enclosed_number(hull(least, most));
  return {.value = both.value, .radius = both.radius, .guaranteed = true};
}

}  // namespace radcert
