// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/direct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/rational.h"
#include "radcert/solve/linear_solver.h"

namespace radcert {
namespace {

using Values = std::vector<double>;

Matrix<double> matrix(std::size_t n, const std::function<double(std::size_t, std::size_t)>& entry) {
  Matrix<double> a(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a(i, j) = entry(i, j);
  return a;
}

/// A number between -1 and 1, a multiple of 1/64.
double small_fraction(std::mt19937_64& random) { return static_cast<double>(random() % 129) / 64 - 1; }

/// (I - K) u = e by Gauss's elimination in rational numbers; nothing if I - K is singular.
std::optional<std::vector<Rational>> exact_solution(const Matrix<double>& k, const Values& e) {
  const std::size_t n = k.rows();
  std::vector<std::vector<Rational>> a(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a[i][j] = Rational(i == j ? 1 : 0) - Rational::exactly(k(i, j));
    a[i][n] = Rational::exactly(e[i]);
  }
  for (std::size_t c = 0; c < n; ++c) {
    const auto pivot = std::find_if(a.begin() + static_cast<std::ptrdiff_t>(c), a.end(),
                                    [c](const auto& row) { return row[c].sign() != 0; });
    if (pivot == a.end()) return std::nullopt;
    std::swap(a[c], *pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == c) continue;
      const Rational factor = a[i][c] / a[c][c];
      for (std::size_t j = c; j <= n; ++j) a[i][j] -= factor * a[c][j];
    }
  }
  std::vector<Rational> u;
  for (std::size_t i = 0; i < n; ++i) u.push_back(a[i][n] / a[i][i]);
  return u;
}

/// ||(I - K)^-1|| in the maximum norm, column by column.
double inverse_norm(const DirectSolver& solver, std::size_t n) {
  Values row_sums(n);
  for (std::size_t j = 0; j < n; ++j) {
    Values unit(n);
    unit[j] = 1;
    const Values column = solver.solve(unit);
    for (std::size_t i = 0; i < n; ++i) row_sums[i] += std::abs(column[i]);
  }
  return *std::max_element(row_sums.begin(), row_sums.end());
}

TEST(DirectSolver, SolvesDyadicSystemsExactly) {
  Matrix<double> k(2, 2);
  k(0, 1) = 0.5;
  k(1, 0) = 0.25;
  EXPECT_EQ(DirectSolver(k).solve(Values{0, 1.75}), (Values{1, 2}));
  EXPECT_EQ(DirectSolver(Matrix<double>(3, 3)).solve(Values{3, -5, 7}), (Values{3, -5, 7}));
  Matrix<double> half(1, 1);
  half(0, 0) = 0.5;
  EXPECT_EQ(DirectSolver(half).solve(Values{3}), Values{6});
}

TEST(DirectSolver, PivotsWhereTheDiagonalVanishes) {
  // I - K is the cyclic permutation (u_2, u_3, u_1).
  const Matrix<double> k = matrix(
      3, [](std::size_t i, std::size_t j) { return (i == j ? 1.0 : 0.0) - (j == (i + 1) % 3 ? 1.0 : 0.0); });
  EXPECT_EQ(DirectSolver(k).solve(Values{2, 3, 1}), (Values{1, 2, 3}));
}

TEST(DirectSolver, AgreesWithExactElimination) {
  std::mt19937_64 random(5);
  for (const std::size_t n : {1U, 2U, 5U, 12U})
    for (int trial = 0; trial < 8; ++trial) {
      const Matrix<double> k = matrix(n, [&](std::size_t, std::size_t) { return small_fraction(random); });
      Values e(n);
      for (double& value : e) value = small_fraction(random);
      const std::optional<std::vector<Rational>> truth = exact_solution(k, e);
      if (!truth) continue;
      const DirectSolver solver(k);
      const Values u = solver.solve(e);
      double size = 0;
      for (const Rational& value : *truth) size = std::max(size, std::abs(value.to_double()));
      // Backward stability: the relative error is a small multiple of n u times the condition number.
      const double condition = inverse_norm(solver, n) * (1 + static_cast<double>(n));
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(u[i], (*truth)[i].to_double(), 1.2e-16 * static_cast<double>(4 * n) * condition * size);
    }
}

TEST(DirectSolver, FindsTheNormOfTheInverseFromAllOfIt) {
  // 100 and more columns: more than are solved for at a time.
  std::mt19937_64 random(6);
  for (const std::size_t n : {1U, 2U, 3U, 10U, 40U, 150U})
    for (const double scale : {0.01, 0.9, 3.0, 100.0}) {
      const Matrix<double> k = matrix(n, [&](std::size_t, std::size_t) {
        return scale / static_cast<double>(n) * small_fraction(random);
      });
      const DirectSolver solver(k);
      const double truth = inverse_norm(solver, n);
      if (!std::isfinite(truth)) continue;
      EXPECT_NEAR(solver.inverse_norm(), truth, 1e-9 * truth) << n << " " << scale;
    }
}

TEST(DirectSolver, KnowsTheNormOfTheInverseOfPositiveMatricesExactly) {
  // K >= 0 with row sums 1/2: (I - K)^-1 >= 0 maps 1 to 2, and that is its norm.
  std::mt19937_64 random(7);
  for (const std::size_t n : {1U, 4U, 30U}) {
    Matrix<double> k = matrix(n, [&](std::size_t, std::size_t) { return 1 + small_fraction(random); });
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += k(i, j);
      for (std::size_t j = 0; j < n; ++j) k(i, j) *= 0.5 / sum;
    }
    EXPECT_NEAR(DirectSolver(k).inverse_norm(), 2, 1e-13);
  }
}

TEST(DirectSolver, SeesOneLargeRowOfTheInverse) {
  // The norm in the maximum norm is a row sum, 1 + 100; the largest column sum is 101 for the transposed
  // only.
  Matrix<double> k(5, 5);
  for (std::size_t j = 1; j < 5; ++j) k(0, j) = 25;
  EXPECT_EQ(DirectSolver(k).inverse_norm(), 101);
}

TEST(DirectSolver, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(8);
  constexpr std::size_t n = 300;
  const Matrix<double> k =
      matrix(n, [&](std::size_t, std::size_t) { return small_fraction(random) / static_cast<double>(n); });
  Values e(n);
  for (double& value : e) value = small_fraction(random);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const DirectSolver solver(k);
    Values results = solver.solve(e);
    results.push_back(solver.inverse_norm());
    return results;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(DirectSolver, RefusesWhatIsNotSquareAndSidesOfAnotherSize) {
  EXPECT_THROW(DirectSolver(Matrix<double>(2, 3)), ContractViolation);
  EXPECT_THROW(DirectSolver(Matrix<double>()), ContractViolation);
  EXPECT_THROW(static_cast<void>(DirectSolver(Matrix<double>(2, 2)).solve(Values{1})), ContractViolation);
}

TEST(DirectSolver, BoundsSolutionsWhereNothingContracts) {
  // (1 - 3/2) u = e with a row that is known within 1/4: u = -2 e, and up to -4 e.
  Matrix<double> k(1, 1);
  k(0, 0) = 1.5;
  const Values radius{0.25};
  const Values e{1};
  const Values e_radius{0};
  const Outcome<LinearSolution> found = find_linear_solver("direct")->eliminate(
      {.k = k, .row_radius = radius, .e = e, .e_radius = e_radius, .contraction = nullptr});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->values[0], -2);
  EXPECT_GE(found->radius, 2);
  EXPECT_LE(found->radius, 2 + 1e-12);
}

}  // namespace
}  // namespace radcert
