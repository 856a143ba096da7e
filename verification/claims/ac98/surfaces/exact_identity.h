// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

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
