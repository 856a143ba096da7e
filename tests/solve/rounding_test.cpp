// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/rounding/rounding.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

/// Lengths up to the longest, in powers of two and beside them.
std::vector<std::size_t> lengths() {
  std::vector<std::size_t> all{1, 2, 3, 5, 6, 7, 100, 1001};
  for (std::size_t n = 4; n <= longest_sum; n *= 2)
    for (const std::size_t beside : {n - 1, n, n + 1})
      if (beside <= longest_sum) all.push_back(beside);
  return all;
}

const Rational unit = power(Rational(2), -53);

TEST(RoundingOfSums, IsTheLeastBoundAndTwoUnits) {
  for (const std::size_t n : lengths()) {
    const Rational part = Rational(static_cast<long>(n)) * unit;
    const Rational bound = Rational::exactly(rounding_of_sums(n));
    EXPECT_GE(bound, part / (1 - part)) << n;
    EXPECT_LE(bound, part + 2 * unit) << n;
  }
}

TEST(RoundingOfSums, IsNearlyAttained) {
  // 1, and numbers just below half a unit of 1, each of which is lost.
  constexpr std::size_t n = 1000;
  constexpr double small = 0x1.fffffp-54;
  double sum = 1;
  Rational exact = 1;
  for (std::size_t k = 1; k < n; ++k) {
    sum += small;
    exact += Rational::exactly(small);
  }
  const Rational off = abs(exact - Rational::exactly(sum)) / exact;
  EXPECT_LE(off, Rational::exactly(rounding_of_sums(n)));
  EXPECT_GE(off, Rational(99, 100) * Rational::exactly(rounding_of_sums(n)));
}

TEST(UpwardOfSums, BoundsTheInverseOfAllRoundingsAndFiveMore) {
  for (const std::size_t n : lengths()) {
    // (1 - u)^m is at least its series up to the third order, whose terms alternate and fall.
    const Rational m(static_cast<long>(n) + 5);
    const Rational at_least = 1 - m * unit + m * (m - 1) / 2 * unit * unit * (1 - (m - 2) / 3 * unit);
    const Rational factor = Rational::exactly(upward_of_sums(n));
    EXPECT_GE(factor * at_least, Rational(1)) << n;
    EXPECT_LE(factor, 1 + (m + 4) * unit) << n;
  }
}

}  // namespace
}  // namespace radcert
