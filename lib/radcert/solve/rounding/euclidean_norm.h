// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace radcert {

/// The 2-norm of a vector, whatever the sizes of its entries.
/// Maths     ||a|| = 2^e ||2^-e a||, 2^e the largest power of two that is not above max |a_i|: then the sum
///           of squares is at least 1, so that squares which underflow, each below 2^-1074, change no more
///           than a rounding does
/// Result    within (n + 3) u ||a||, or the least positive double, of it; 0 for no vector but 0; the bits are
///           those of the plain sum of squares wherever that neither underflows nor overflows. Infinite or
///           NaN where an entry is
[[nodiscard]] double euclidean_norm(std::span<const double> a);

/// The same, rounded up.
[[nodiscard]] double euclidean_norm_from_above(std::span<const double> a);

/// 2^exponent x, rounded up.
/// Requires  x >= 0
/// Result    the exact product wherever that is a double
[[nodiscard]] double scaled_from_above(double x, int exponent);

/// The power of two by which the numbers of a vector become at most 2 in size and one at least 1.
/// Result    e with 2^e <= max |a_i| < 2^(e+1); 0 for the vector 0 and where an entry is infinite or NaN
[[nodiscard]] int binary_exponent(std::span<const double> a);

}  // namespace radcert
