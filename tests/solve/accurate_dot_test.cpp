// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/accurate_dot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

/// A row as a matrix, and what it should be multiplied with.
struct Sum {
  Matrix<double> row;
  std::vector<double> x;

  explicit Sum(std::size_t n) : row(1, n), x(n) {}
  Rational exact() const {
    Rational sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) sum += Rational::exactly(row(0, j)) * Rational::exactly(x[j]);
    return sum;
  }
  Rational absolute() const {
    Rational sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += abs(Rational::exactly(row(0, j)) * Rational::exactly(x[j]));
    return sum;
  }
};

/// Random terms of very different sizes, the last chosen so that the sum nearly vanishes.
Sum ill_conditioned(std::mt19937_64& random, std::size_t n, int decades) {
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
  Sum sum(n);
  for (std::size_t j = 0; j + 1 < n; ++j) {
    const int shift = static_cast<int>(random() % static_cast<unsigned>(decades + 1));
    sum.row(0, j) = std::ldexp(uniform(), shift);
    sum.x[j] = std::ldexp(uniform(), static_cast<int>(random() % static_cast<unsigned>(decades + 1)));
  }
  sum.x[n - 1] = 1;
  sum.row(0, n - 1) = -sum.exact().to_double();
  return sum;
}

TEST(AccurateProduct, IsAsIfSummedInTwiceTheWorkingPrecision) {
  std::mt19937_64 random(11);
  for (const std::size_t n : {2U, 3U, 10U, 100U, 1000U})
    for (const int decades : {0, 10, 30, 60})
      for (int trial = 0; trial < 5; ++trial) {
        const Sum sum = ill_conditioned(random, n, decades);
        const Rational exact = sum.exact();
        const Rational error = abs(Rational::exactly(accurate_product(sum.row, sum.x)[0]) - exact);
        const Rational second_order = power(Rational(static_cast<long>(n)) * Rational::exactly(unit), 2);
        EXPECT_LE(error, Rational::exactly(unit) * abs(exact) + second_order * sum.absolute())
            << n << " terms, " << decades << " powers of two: off by " << error.to_double();
      }
}

TEST(AccurateProduct, KeepsWhatPlainSumsLose) {
  Sum sum(3);
  sum.row(0, 0) = 0x1p60;
  sum.row(0, 1) = 1;
  sum.row(0, 2) = -0x1p60;
  sum.x = {1, 1, 1};
  EXPECT_EQ(accurate_product(sum.row, sum.x), std::vector<double>{1});
  // (1 + e)(1 - e) - 1 = -e^2
  Sum square(2);
  square.row(0, 0) = 1 + 0x1p-40;
  square.x[0] = 1 - 0x1p-40;
  square.row(0, 1) = -1;
  square.x[1] = 1;
  EXPECT_EQ(accurate_product(square.row, square.x), std::vector<double>{-0x1p-80});
}

TEST(AccurateProduct, IsTheMatrixTimesTheVector) {
  Matrix<double> a(2, 3);
  a(0, 0) = 1;
  a(0, 1) = 2;
  a(0, 2) = 3;
  a(1, 0) = -4;
  a(1, 1) = 5;
  a(1, 2) = -6;
  EXPECT_EQ(accurate_product(a, std::vector<double>{1, 10, 100}), (std::vector<double>{321, -554}));
  EXPECT_EQ(accurate_product(Matrix<double>(2, 0), {}), (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace radcert
