// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/scalar/real.h"

namespace radcert {

/// The longest sums of which the two bounds below speak.
inline constexpr std::size_t longest_sum = std::size_t{1} << 26U;

/// What rounding does to a sum of n products, in parts of the sum of their sizes.
/// Maths     each product passes n roundings at most: gamma_n = n u / (1 - n u) <= (n + 2) u, since
///           n u gamma_n <= 2 u for n <= 2^26
/// Source    Higham, Accuracy and Stability of Numerical Algorithms, 2002, 3.1
/// Requires  n <= longest_sum
/// Result    at least gamma_n: n + 2 and its product with a power of two are exact
[[nodiscard]] constexpr double rounding_of_sums(std::size_t n) {
  return (static_cast<double>(n) + 2) * unit_roundoff<double>();
}

/// The factor that makes the rounded sum of n products >= 0 an upper bound.
/// Maths     the exact sum is at most that of the machine over (1 - u)^n, and (1 - u)^-n <= 1 + (n + 1) u for
///           n <= 2^26; seven units are left for a handful of roundings around it
/// Requires  n <= longest_sum; what underflows is the caller's
/// Result    at least (1 - u)^-(n+6), its own rounding counted
[[nodiscard]] constexpr double upward_of_sums(std::size_t n) {
  return 1 + (static_cast<double>(n) + 8) * unit_roundoff<double>();
}

}  // namespace radcert
