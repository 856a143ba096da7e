// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// The second derivative of Ku at a corner of a curved piece, held against a limit.
/// Maths     S = two_piece(2), rho = 1/2, u = 1 on the roof: Ku in C^2(S) would make the difference of its
///           mixed derivatives at (t, t^2) and (t^2, t) tend to 0; it tends to 1/(2 pi)
/// Source    against [ac98, Lemma 2.3], [m06, Lemma 2]
/// Result    contradicts them for m = 1, for all 0 < t <= 2^-12 at once; the same differences on a side and
///           inside do tend to 0
[[nodiscard]] Finding mixed_derivative_at_a_corner();

/// The same for the solution u of (1) with E = 1.
/// Maths     the difference tends to u(0,0) times that for u = 1, as r |dG/dP| and r^2 |G_xy| are bounded,
///           and u(0,0) >= 1
/// Source    against [ac98, Theorem 2.4 (b)], [m06, Theorem 3 (b)]
/// Result    contradicts them for m = 2
/// Limits    the bounds are computed; what follows from them is in words
[[nodiscard]] Finding mixed_derivative_of_the_solution_at_a_corner();

}  // namespace radcert::verification::ac98
