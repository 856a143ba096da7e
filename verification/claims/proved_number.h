// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/enclosure/demand.h"
#include "radcert/scalar/ball.h"
#include "verification/framework/finding.h"

namespace radcert::verification {

/// A ball as a number with a proved radius, for statements on doubles.
/// Maths     value +- radius contains the ball
/// Result    guaranteed; infinite where the ball has failed, which settles nothing
/// Limits    an inequality a <= b is proved by AtMost{0} for proved(a - b): a double that is added to its
///           radius has the sign of the exact sum or is zero
[[nodiscard]] inline Approximation proved(const Ball& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double low = x.lower_double();
  const double high = x.upper_double();
  if (!std::isfinite(low) || !std::isfinite(high)) return {.value = infinity, .radius = infinity};
  const double value = low + (high - low) / 2;
  return {.value = value,
          .radius = low == high ? 0 : std::nextafter(std::max(high - value, value - low), infinity),
          .guaranteed = true};
}

/// What is known of the number: the ball demanded, or what was reached.
[[nodiscard]] inline Ball known(const Enclosure& number) {
  return number ? number->value : number.reason().reached;
}

}  // namespace radcert::verification
