// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/rational.h"

namespace radcert::verification::m06 {

/// In how many terms the inverse of f -> f - R M(f), M a mean and R a function, is missed from the right.
/// Maths     with q = M(R): (1 - q)(g - R M(g) - f) for g = f + R M(f)/(1 - q), where M(g) (1 - q) =
///           (1 - q) M(f) + q M(f). K is such an operator on the unit sphere, and so is P_n K
/// Source    ours
/// Result    exact, for all f and R; 0 for `sign` -1. For 1 a wrong g, with 1 + q in the place of 1 - q
[[nodiscard]] Rational terms_of_right_inverse(int sign);

/// The same from the left: there is no other g.
/// Maths     (1 - q)(Y (f - R M(f)) - f) for Y g = g + R M(g)/(1 - q), where M(f - R M(f)) = M(f) - q M(f)
[[nodiscard]] Rational terms_of_left_inverse(int sign);

}  // namespace radcert::verification::m06
