// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/rounding/euclidean_norm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();

TEST(EuclideanNorm, IsFiveForThreeAndFourAtEveryScale) {
  for (const int exponent : {-1074, -1060, -1022, -800, -540, -500, 0, 500, 512, 900, 1021}) {
    const std::vector<double> a{std::ldexp(3.0, exponent), std::ldexp(-4.0, exponent)};
    EXPECT_EQ(euclidean_norm(a), std::ldexp(5.0, exponent)) << exponent;
    EXPECT_GE(euclidean_norm_from_above(a), std::ldexp(5.0, exponent)) << exponent;
    EXPECT_LE(euclidean_norm_from_above(a), std::ldexp(5.0, exponent) * (1 + 1e-14) + 2 * least) << exponent;
  }
}

TEST(EuclideanNorm, FromAboveIsAbove) {
  for (const int exponent : {-1074, -1073, -1040, -600, 0, 600})
    for (const std::vector<double>& a :
         {std::vector<double>{1, 1}, std::vector<double>{1, 2, 3}, std::vector<double>{1, 0x1p-530, 0x1p-540},
          std::vector<double>(1000, 3.0)}) {
      std::vector<double> scaled(a);
      Rational square = 0;
      for (double& value : scaled) {
        value = std::ldexp(value, exponent);
        square += Rational::exactly(value) * Rational::exactly(value);
      }
      const Rational norm = Rational::exactly(euclidean_norm_from_above(scaled));
      EXPECT_GE(norm * norm, square) << exponent << " " << a.size();
    }
}

TEST(EuclideanNorm, IsZeroForZeroAlone) {
  EXPECT_EQ(euclidean_norm(std::vector<double>(3)), 0);
  EXPECT_EQ(euclidean_norm_from_above(std::vector<double>(3)), 0);
  EXPECT_EQ(euclidean_norm(std::vector<double>{}), 0);
  EXPECT_GE(euclidean_norm(std::vector<double>{0, least}), least);
}

TEST(EuclideanNorm, SaysWhereNumbersEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(euclidean_norm(std::vector<double>{1, -infinity}), infinity);
  EXPECT_EQ(euclidean_norm_from_above(std::vector<double>(9, 0x1.8p1023)), infinity);
  EXPECT_TRUE(std::isnan(euclidean_norm(std::vector<double>{1, std::nan("")})));
}

TEST(BinaryExponent, IsThatOfTheLargest) {
  EXPECT_EQ(binary_exponent(std::vector<double>{0.25, -3, 1}), 1);
  EXPECT_EQ(binary_exponent(std::vector<double>{least}), -1074);
  EXPECT_EQ(binary_exponent(std::vector<double>(2)), 0);
}

TEST(ScaledFromAbove, IsExactOrTheNextAbove) {
  EXPECT_EQ(scaled_from_above(3, -1074), 3 * least);
  EXPECT_EQ(scaled_from_above(1, -1075), least);
  EXPECT_EQ(scaled_from_above(1, -3000), least);
  EXPECT_EQ(scaled_from_above(0, -3000), 0);
  // Five quarters and seven quarters of the least number.
  EXPECT_EQ(scaled_from_above(1.25, -1074), 2 * least);
  EXPECT_EQ(scaled_from_above(1.75, -1074), 2 * least);
}

}  // namespace
}  // namespace radcert
