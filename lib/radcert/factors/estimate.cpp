// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/estimate.h"

namespace radcert {

Estimate enclosing_estimate(const Ball& ball) {
  const double value = ball.to_double();
  return {value, abs(ball - Ball(value)).upper_double()};
}

Ball enclosing_ball(const Estimate& estimate) { return widened(Ball(estimate.value), Ball(estimate.radius)); }

}  // namespace radcert
