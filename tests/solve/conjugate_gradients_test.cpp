// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/conjugate_gradients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// K with eigenvalues `eigenvalues` and the Householder reflection of a random vector as eigenvectors.
Matrix<double> symmetric(const std::vector<double>& eigenvalues, unsigned seed) {
  const std::size_t n = eigenvalues.size();
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> w(n);
  double square = 0;
  for (double& x : w) {
    x = normal(random);
    square += x * x;
  }
  Matrix<double> q(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) q(i, j) = (i == j ? 1.0 : 0.0) - 2 * w[i] * w[j] / square;
  Matrix<double> k(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t m = 0; m < n; ++m) sum += q(i, m) * eigenvalues[m] * q(j, m);
      k(i, j) = k(j, i) = sum;
    }
  return k;
}

std::vector<double> spread(std::size_t n, double from, double to) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i)
    values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(n - 1);
  return values;
}

/// b = (I - K) x in long double, rounded once.
std::vector<double> right_hand_side(const Matrix<double>& k, const std::vector<double>& x) {
  std::vector<double> b(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    long double sum = x[i];
    for (std::size_t j = 0; j < x.size(); ++j) sum -= static_cast<long double>(k(i, j)) * x[j];
    b[i] = static_cast<double>(sum);
  }
  return b;
}

TEST(ConjugateGradients, BoundTheErrorInBothNorms) {
  for (const double largest : {0.5, 0.9, 0.999})
    for (const std::optional<double> tolerance :
         {std::optional(1e-2), std::optional(1e-6), std::optional<double>()}) {
      const Matrix<double> k = symmetric(spread(60, -0.3, largest), 7);
      std::vector<double> x(60);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i * i));
      const std::vector<double> b = right_hand_side(k, x);
      const auto found = solve_by_conjugate_gradients(k, b, (1 - largest) * (1 - 1e-12), tolerance);
      ASSERT_TRUE(found) << found.reason();
      std::vector<double> error(60);
      double norm = 0;
      double size = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        error[i] = x[i] - found->values[i];
        norm += error[i] * error[i];
        size += x[i] * x[i];
      }
      double energy = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        energy += error[i] * error[i];
        for (std::size_t j = 0; j < x.size(); ++j) energy -= error[i] * k(i, j) * error[j];
      }
      // What rounding b has changed in x.
      const double rounded = 1e-15 * std::sqrt(size) / (1 - largest);
      EXPECT_LE(std::sqrt(norm), found->error_bound + rounded);
      EXPECT_LE(std::sqrt(std::max(energy, 0.0)), found->energy_bound + rounded);
      EXPECT_LE(found->error_bound, tolerance.value_or(1e-12) * 1.1 * std::sqrt(size));
      EXPECT_LE(found->iterations, 1000U);
    }
}

TEST(ConjugateGradients, HaveBoundsThatAreAttained) {
  // The right-hand side is an eigenvector of the least eigenvalue: before any step ||x||_2 = ||b||_2 / lower,
  // and a bound with anything else in place of it would be wrong or wide.
  Matrix<double> k(2, 2);
  k(0, 0) = 0.75;
  const auto found = solve_by_conjugate_gradients(k, std::vector<double>{1, 0x1p-40}, 0.25, 1.0);
  ASSERT_TRUE(found);
  const double x = 4;
  EXPECT_GE(found->error_bound, std::abs(x - found->values[0]));
  EXPECT_NEAR(found->residual / found->error_bound, 0.25, 1e-12);
  EXPECT_NEAR(found->residual / found->energy_bound, 0.5, 1e-12);
}

TEST(ConjugateGradients, SolveNothingWithNothing) {
  const auto found = solve_by_conjugate_gradients(Matrix<double>(3, 3), std::vector<double>(3), 1, 1e-6);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->values, std::vector<double>(3));
  EXPECT_EQ(found->error_bound, 0);
}

TEST(ConjugateGradients, SeeAMatrixThatIsNotPositiveDefinite) {
  Matrix<double> k(2, 2);
  k(0, 0) = 3;
  EXPECT_FALSE(solve_by_conjugate_gradients(k, std::vector<double>{1, 0}, 0.1, std::nullopt));
}

TEST(ConjugateGradients, RefuseAToleranceBeyondTheArithmetic) {
  const Matrix<double> k = symmetric(spread(30, 0, 0.9), 3);
  const std::vector<double> b(30, 1.0);
  EXPECT_FALSE(solve_by_conjugate_gradients(k, b, 0.1, 1e-40));
  EXPECT_THROW((void)solve_by_conjugate_gradients(k, b, 0, 0.1), ContractViolation);
}

/// ||2^exponent x - v||_2, in long double.
long double distance(const std::vector<double>& x, int exponent, const std::vector<double>& v) {
  long double square = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double difference = std::ldexp(static_cast<long double>(x[i]), exponent) - v[i];
    square += difference * difference;
  }
  return std::sqrt(square);
}

TEST(ConjugateGradients, SolveAtEveryScaleToTheBit) {
  const Matrix<double> k = symmetric(spread(40, -0.3, 0.9), 5);
  std::vector<double> b(40);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::cos(static_cast<double>(i * i));
  for (const std::optional<double> tolerance : {std::optional(1e-6), std::optional<double>()}) {
    const auto plain = solve_by_conjugate_gradients(k, b, 0.0999, tolerance);
    ASSERT_TRUE(plain);
    for (const int exponent : {-1, -500, -540, -600, -900, 500, 511, 600, 1000}) {
      std::vector<double> scaled(b);
      for (double& value : scaled) value = std::ldexp(value, exponent);
      const auto found = solve_by_conjugate_gradients(k, scaled, 0.0999, tolerance);
      ASSERT_TRUE(found) << exponent << ": " << found.reason();
      for (std::size_t i = 0; i < b.size(); ++i)
        EXPECT_EQ(found->values[i], std::ldexp(plain->values[i], exponent)) << exponent;
      EXPECT_EQ(found->residual, std::ldexp(plain->residual, exponent)) << exponent;
      EXPECT_EQ(found->error_bound, std::ldexp(plain->error_bound, exponent)) << exponent;
      EXPECT_EQ(found->energy_bound, std::ldexp(plain->energy_bound, exponent)) << exponent;
    }
  }
}

TEST(ConjugateGradients, CountWhatIsRoundedBelowTheNormalRange) {
  const Matrix<double> k = symmetric(spread(30, -0.3, 0.9), 5);
  for (const int exponent : {-1030, -1050, -1064, -1070, -1074}) {
    // Whole multiples of the least number, so that the right-hand sides are exactly multiples of each other.
    std::vector<double> whole(30);
    std::vector<double> b(30);
    for (std::size_t i = 0; i < b.size(); ++i) {
      whole[i] = std::round(7 * std::cos(static_cast<double>(i * i)));
      b[i] = std::ldexp(whole[i], exponent);
    }
    const auto exact = solve_by_conjugate_gradients(k, whole, 0.0999, std::nullopt);
    const auto found = solve_by_conjugate_gradients(k, b, 0.0999, std::nullopt);
    ASSERT_TRUE(exact && found);
    const long double error = distance(exact->values, exponent, found->values);
    EXPECT_GT(found->residual, 0);
    EXPECT_LE(error, found->error_bound + std::ldexp(static_cast<long double>(exact->error_bound), exponent))
        << exponent;
    // Below the normal range no digits are left for this.
    EXPECT_FALSE(solve_by_conjugate_gradients(k, b, 0.0999, 1e-15)) << exponent;
  }
}

TEST(ConjugateGradients, RefuseNumbersBeyondTheRange) {
  Matrix<double> k(1, 1);
  k(0, 0) = 0.9375;
  EXPECT_FALSE(solve_by_conjugate_gradients(k, std::vector<double>{0x1p1021}, 0.0625, 0.5));
  EXPECT_TRUE(solve_by_conjugate_gradients(k, std::vector<double>{0x1p1018}, 0.0625, 0.5));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solve_by_conjugate_gradients(k, std::vector<double>{infinity}, 0.0625, 0.5));
}

}  // namespace
}  // namespace radcert
