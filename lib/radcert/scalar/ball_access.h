// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert {

/// The inside of a ball, for the sources that compute with Arb.
/// Source    Arb
/// Requires  whoever writes into storage() leaves a finite arb_t, or calls fail(): a ball is finite or the
///           whole line
/// Result    storage() is the arb_t; failure() is null where the ball is finite
/// Limits    not for formulas
struct BallAccess {
  static void* storage(Ball& ball) noexcept { return ball.storage_.data(); }
  static const void* storage(const Ball& ball) noexcept { return ball.storage_.data(); }
  static const char* failure(const Ball& ball) noexcept { return ball.failure_; }
  static void fail(Ball& ball, const char* reason);
  /// Whether so few bits are known that the rules for small radii overestimate, and the sign may be open.
  static bool is_wide(const Ball& ball);
  /// The part of a finite ball that is not negative, where none of what the ball stands for is: [0, u].
  static Ball nonnegative(Ball ball);
};

}  // namespace radcert
