// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// The second derivative of Ku at a corner of a curved piece, held against a limit.
/// Maths     S = two_piece(2), rho = 1/2, u = 1 on the roof: Ku in C^2(S) would make the difference of its
///           mixed derivatives at (t, t^2) and (t^2, t) tend to 0; it tends to 1/(2 pi)
/// Source    against [ac98, Lemma 2.3 and Theorem 2.4 (b)], [m06, Lemma 2 and Theorem 3 (b)]
/// Result    contradicts them for m = 1, (b) for m = 2; the same differences on a side and inside do tend to
///           0
/// Limits    K u is enclosed; the step from there to the solution u is in words
[[nodiscard]] Finding mixed_derivative_at_a_corner();

}  // namespace radcert::verification::ac98
