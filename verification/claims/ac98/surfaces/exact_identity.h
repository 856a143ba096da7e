// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// At how many points of a grid of `values` values in each of n variables two rational functions differ.
/// Maths     a polynomial of degree below `values` in each variable that vanishes on such a grid is zero: 0
///           proves an identity of functions whose difference, over its common denominator, has such a
///           numerator. The k-th variable takes the values j + (k+1)/(n+1), j = 0, 1, ...: positive, and no
///           two variables take the same one
/// Requires  functions of std::array<Rational, n> without a pole there
/// Result    exact
/// Limits    the degrees are for the caller to see to
template <std::size_t n, class Left, class Right>
Rational differing_on_grid(long values, const Left& left, const Right& right) {
  std::array<long, n> at{};
  long count = 0;
  while (true) {
    std::array<Rational, n> x;
    for (std::size_t k = 0; k < n; ++k)
      x[k] = Rational(at[k]) + Rational(static_cast<long>(k) + 1, static_cast<long>(n) + 1);
    if (left(x) != right(x)) ++count;
    std::size_t k = 0;
    while (k < n && ++at[k] == values) at[k++] = 0;
    if (k == n) return {count};
  }
}

/// At how many points of a grid two rational functions of s, eta and z differ.
/// Maths     a polynomial of degree at most 8 in each variable that vanishes on a grid of 9 values each is
///           zero: 0 proves an identity of functions whose difference, over its common denominator, has such
///           a numerator
/// Requires  functions without a pole where eta, z > 0
/// Result    exact
/// Limits    the degrees are for the caller to see to
template <class Left, class Right>
Rational differing_points(const Left& left, const Right& right) {
  constexpr long values = 9;
  long count = 0;
  for (long i = 0; i < values; ++i)
    for (long j = 0; j < values; ++j)
      for (long k = 0; k < values; ++k) {
        const Rational s(i - 3, 4);
        const Rational eta(j + 1, 5);
        const Rational z(k + 1, 7);
        if (left(s, eta, z) != right(s, eta, z)) ++count;
      }
  return {count};
}

}  // namespace radcert::verification::ac98
