// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/tensor_legendre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace radcert {
namespace {

/// Two functions of degree 1, by the coefficients of 1, P_1(y), P_1(x), P_1(x) P_1(y).
SectorFunctions two_functions(const std::array<double, 4>& first, const std::array<double, 4>& second) {
  SectorFunctions f(1, 2, 1);
  std::copy(first.begin(), first.end(), f.of(0, 0).begin());
  std::copy(second.begin(), second.end(), f.of(0, 1).begin());
  return f;
}

constexpr std::array<double, 4> steep{1, -2, 4, 0};
constexpr std::array<double, 4> twisted{0.5, 0, 0, -8};

TEST(PolynomialSizes, AreSumsOverTheOtherVariableTheLargestOfAllFunctions) {
  const std::vector<double> by_s{3, 8};
  const std::vector<double> by_t{5, 8};
  for (const SectorFunctions& f : {two_functions(steep, twisted), two_functions(twisted, steep)}) {
    const PolynomialSizes sizes = polynomial_sizes(f, 0, 0, 2);
    EXPECT_EQ(sizes.by_s, by_s);
    EXPECT_EQ(sizes.by_t, by_t);
  }
  const PolynomialSizes of_one = polynomial_sizes(two_functions(twisted, steep), 0, 1, 2);
  EXPECT_EQ(of_one.by_s, (std::vector<double>{3, 4}));
  EXPECT_EQ(of_one.by_t, (std::vector<double>{5, 2}));
}

TEST(SizeAround, GrowsWithThePowersInEitherVariable) {
  for (const SectorFunctions& f : {two_functions(steep, twisted), two_functions(twisted, steep)}) {
    // 1 + 2 * 1.5 + 4 * 3 and 1/2 + 8 * 3 * 1.5; 1 + 2 * 2 + 4 and 1/2 + 8 * 2 where it grows across alone.
    EXPECT_GE(size_around(f, 0, 3, 1.5), 36.5);
    EXPECT_LE(size_around(f, 0, 3, 1.5), 36.5 * (1 + 1e-9));
    EXPECT_GE(size_around(f, 0, 1, 2), 16.5);
    EXPECT_GE(size_around(f, 0, 10, 1), 80.5);
    EXPECT_LE(size_around(f, 0, 10, 1), 80.5 * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace radcert
