// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/product.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/real.h"
#include "tests/solve/systems.h"

namespace radcert {
namespace {

using test::Values;

TEST(Multiply, KeepsToTheBoundOfAPlainSum) {
  std::mt19937_64 random(21);
  for (const std::size_t n : {1U, 3U, 255U, 256U, 257U, 300U}) {
    const Matrix<double> a = test::matrix(n, [&](std::size_t, std::size_t) {
      return std::ldexp(test::uniform(random), static_cast<int>(random() % 40));
    });
    const Values x = test::random_values(random, n);
    Values y(n, -7);
    Values sizes(n, -7);
    Values x_sizes = x;
    for (double& value : x_sizes) value = std::abs(value);
    multiply(a, x, y);
    multiply_sizes(a, x_sizes, sizes);
    for (std::size_t i = 0; i < n; i += 1 + n / 40) {
      Rational exact = 0;
      Rational absolute = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const Rational term = Rational::exactly(a(i, j)) * Rational::exactly(x[j]);
        exact += term;
        absolute += abs(term);
      }
      const Rational bound =
          Rational::exactly(1.01 * static_cast<double>(n) * unit_roundoff<double>()) * absolute;
      EXPECT_LE(abs(Rational::exactly(y[i]) - exact), bound) << "row " << i << " of " << n;
      EXPECT_LE(abs(Rational::exactly(sizes[i]) - absolute), bound) << "row " << i << " of " << n;
    }
  }
}

TEST(Multiply, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(22);
  constexpr std::size_t n = 700;
  const Matrix<double> a = test::random_matrix(random, n, 1, false);
  const Values x = test::random_values(random, n);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    Values y(n);
    Values sizes(n);
    multiply(a, x, y);
    multiply_sizes(a, x, sizes);
    y.insert(y.end(), sizes.begin(), sizes.end());
    return y;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(Multiply, RefusesVectorsOfAnotherShape) {
  Values two(2);
  Values three(3);
  EXPECT_THROW(multiply(Matrix<double>(2, 3), two, two), ContractViolation);
  EXPECT_THROW(multiply(Matrix<double>(2, 3), three, three), ContractViolation);
  EXPECT_NO_THROW(multiply(Matrix<double>(2, 3), three, two));
}

}  // namespace
}  // namespace radcert
