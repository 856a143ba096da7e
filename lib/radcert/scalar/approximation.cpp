// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/approximation.h"

namespace radcert {

Approximation enclosing(const Ball& ball) {
  const double value = ball.to_double();
  return Approximation::proved(value, abs(ball - Ball(value)).upper_double());
}

Ball ball_of(const Approximation& number) { return widened(Ball(number.value), Ball(number.radius)); }

Approximation max_abs(std::span<const Approximation> numbers) {
  Ball least = 0;
  Ball most = 0;
  bool guaranteed = true;
  for (const Approximation& number : numbers) {
    const Ball size = abs(Ball(number.value));
    least = max(least, size - Ball(number.radius));
    most = max(most, size + Ball(number.radius));
    guaranteed = guaranteed && number.guaranteed;
  }
  Approximation both = enclosing(hull(least, most));
  both.guaranteed = guaranteed;
  return both;
}

}  // namespace radcert
