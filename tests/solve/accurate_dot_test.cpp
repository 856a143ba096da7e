// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/rounding/accurate_dot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
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

TEST(AccurateProduct, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(12);
  constexpr std::size_t n = 600;
  Matrix<double> a(n, n);
  std::vector<double> x(n);
  for (std::size_t j = 0; j < n; ++j) {
    x[j] = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
    for (double& entry : a.column(j)) entry = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
  }
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    std::vector<double> y = accurate_product(a, x);
    std::vector<double> r(n);
    accurate_residual(a, x, y, r);
    y.insert(y.end(), r.begin(), r.end());
    return y;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(AccurateResidual, KeepsTheDigitsThatCancel) {
  // v solves (I - K) v = e to the last bit of each entry but one, and the residual says by how much it does
  // not.
  std::mt19937_64 random(13);
  for (const std::size_t n : {1U, 5U, 300U}) {
    Matrix<double> k(n, n);
    std::vector<double> v(n);
    std::vector<double> e(n);
    for (std::size_t j = 0; j < n; ++j) {
      v[j] = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
      for (double& entry : k.column(j)) entry = (static_cast<double>(random() >> 11U) * 0x1p-52 - 1) / 8;
    }
    std::vector<Rational> exact(n);
    for (std::size_t i = 0; i < n; ++i) {
      Rational right = Rational::exactly(v[i]);
      for (std::size_t j = 0; j < n; ++j) right -= Rational::exactly(k(i, j)) * Rational::exactly(v[j]);
      e[i] = right.to_double();
      exact[i] = Rational::exactly(e[i]) - right;
    }
    std::vector<double> r(n);
    accurate_residual(k, v, e, r);
    const double terms = static_cast<double>(n) + 3;
    const Rational second_order = Rational::exactly(terms * unit * terms * unit * (2 + terms / 8));
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_LE(abs(Rational::exactly(r[i]) - exact[i]),
                Rational::exactly(unit) * abs(exact[i]) + second_order)
          << "row " << i << " of " << n;
  }
}

TEST(AccurateProduct, RefusesVectorsOfAnotherSize) {
  std::vector<double> two(2);
  std::vector<double> three(3);
  EXPECT_THROW(static_cast<void>(accurate_product(Matrix<double>(2, 3), two)), ContractViolation);
  EXPECT_THROW(accurate_residual(Matrix<double>(2, 2), two, two, three), ContractViolation);
  EXPECT_THROW(accurate_residual(Matrix<double>(2, 2), three, two, two), ContractViolation);
  EXPECT_THROW(accurate_residual(Matrix<double>(2, 3), three, two, two), ContractViolation);
}

}  // namespace
}  // namespace radcert
