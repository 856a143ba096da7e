// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/contraction.h"

#include <gtest/gtest.h>

#include <limits>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "tests/solve/systems.h"

namespace radcert {
namespace {

using test::Values;

constexpr double infinity = std::numeric_limits<double>::infinity();

Matrix<double> two_by_two(double a, double b, double c, double d) {
  Matrix<double> k(2, 2);
  k(0, 0) = a;
  k(0, 1) = b;
  k(1, 0) = c;
  k(1, 1) = d;
  return k;
}

/// Whether |K| w <= theta w, in rational numbers.
void expect_contracts(const Matrix<double>& k, const Contraction& contraction) {
  const std::span<const double> w = contraction.weights();
  for (std::size_t i = 0; i < k.rows(); ++i) {
    Rational sum = 0;
    for (std::size_t j = 0; j < k.columns(); ++j)
      sum += abs(Rational::exactly(k(i, j))) * Rational::exactly(w[j]);
    EXPECT_LE(sum, Rational::exactly(contraction.theta()) * Rational::exactly(w[i])) << "row " << i;
  }
}

TEST(FindContraction, ProvesItsInequalityForRandomMatrices) {
  std::mt19937_64 random(31);
  for (const std::size_t n : {1U, 2U, 5U, 40U, 150U})
    for (const double row_sum : {1e-300, 0.1, 0.5, 0.999, 1.1})
      for (const bool positive : {true, false}) {
        const Matrix<double> k = test::random_matrix(random, n, row_sum, positive);
        const auto found = find_contraction(k);
        if (!found) {
          EXPECT_GT(row_sum, 1) << n;
          continue;
        }
        expect_contracts(k, *found);
        EXPECT_LT(found->theta(), 1);
        EXPECT_LE(found->theta(), row_sum * (1 + 1e-12) + 1e-300);
        EXPECT_EQ(*std::max_element(found->weights().begin(), found->weights().end()), 1);
        EXPECT_GT(found->least_weight(), 0);
      }
}

TEST(FindContraction, HoldsForEveryMatrixWithinTheRadii) {
  std::mt19937_64 random(32);
  for (int trial = 0; trial < 20; ++trial) {
    constexpr std::size_t n = 12;
    const Matrix<double> k = test::random_matrix(random, n, 0.9, false);
    Values radius(n);
    for (double& r : radius) r = 0.03 * std::abs(test::uniform(random));
    const auto found = find_contraction(k, radius);
    ASSERT_TRUE(found);
    Matrix<double> other = k;
    // All of a row's radius, or a little less for the rounding, in the entry with the largest weight.
    const auto heaviest = static_cast<std::size_t>(
        std::max_element(found->weights().begin(), found->weights().end()) - found->weights().begin());
    for (std::size_t i = 0; i < n; ++i)
      other(i, heaviest) += (other(i, heaviest) < 0 ? -1 : 1) * radius[i] * (1 - 1e-9);
    expect_contracts(other, *found);
  }
}

/// All rows alike: `first`, then numbers that the sums round, each by nearly half a unit of `first`.
Matrix<double> rows_of_sums_that_round(std::size_t n, double first, double other) {
  return test::matrix(n, [&](std::size_t, std::size_t j) { return j == 0 ? first : other; });
}

TEST(FindContraction, RoundsThetaUpOverAllProductsOfARow) {
  // Each number after the first is lost.
  constexpr std::size_t n = 300;
  constexpr double lost = 0x1.fffffp-55;
  const auto found = find_contraction(rows_of_sums_that_round(n, 0.5, lost));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->least_weight(), 1);
  const Rational sum = Rational(1, 2) + Rational(n - 1) * Rational::exactly(lost);
  EXPECT_GE(Rational::exactly(found->theta()), sum);
  EXPECT_LE(Rational::exactly(found->theta()), sum + Rational(30) * power(Rational(2), -53));
}

TEST(FindContraction, KnowsTheSpectralRadiusFromBelow) {
  // Each number after the first counts nearly twice. The spectral radius is the sum of a row.
  constexpr std::size_t n = 300;
  constexpr double doubled = 0x1.00001p-53;
  const auto found = find_contraction(rows_of_sums_that_round(n, 1, doubled));
  ASSERT_FALSE(found);
  const Rational sum = 1 + Rational(n - 1) * Rational::exactly(doubled);
  EXPECT_LE(Rational::exactly(found.reason().radius_from_below), sum);
  EXPECT_GE(Rational::exactly(found.reason().radius_from_below),
            sum - Rational(30) * power(Rational(2), -53));
  // And with radii that of the least matrix.
  const auto wide = find_contraction(two_by_two(0.75, 0.75, 0.75, 0.75), Values{0.25, 0.25});
  ASSERT_FALSE(wide);
  EXPECT_LE(wide.reason().radius_from_below, 1.25);
  EXPECT_GE(wide.reason().radius_from_below, 1.25 * (1 - 1e-14));
}

TEST(FindContraction, IsTheMaximumNormWhereTheRowSumsAreEqual) {
  std::mt19937_64 random(33);
  const Matrix<double> k =
      test::matrix(64, [&](std::size_t, std::size_t) { return (random() % 2 == 0 ? 0.5 : -0.5) / 64; });
  const auto found = find_contraction(k);
  ASSERT_TRUE(found);
  EXPECT_GE(found->theta(), 0.5);
  EXPECT_LE(found->theta(), 0.5 * (1 + 1e-13));
  EXPECT_EQ(found->least_weight(), 1);
}

TEST(FindContraction, FindsWeightsWhereRowSumsExceedOne) {
  // Spectral radii sqrt(0.15), with period two; 0.9; 0, in as many steps as the large entry needs.
  for (const auto& [k, radius] : {std::pair{two_by_two(0, 1.5, 0.1, 0), std::sqrt(0.15)},
                                  {two_by_two(0.9, 50, 0, 0.1), 0.9},
                                  {two_by_two(0, -100, 0, 0), 0.0}}) {
    const auto found = find_contraction(k);
    ASSERT_TRUE(found);
    expect_contracts(k, *found);
    EXPECT_GE(found->theta(), radius);
    EXPECT_LT(found->theta(), 0.99);
  }
}

TEST(FindContraction, FindsThemForCollocationMatricesWhoseRowSumsExceedOne) {
  const CollocationMatrix<double> k = test::collocation_matrix("cube", 0, 2, 0.87, 1.0 / 6);
  double norm = 0;
  for (std::size_t i = 0; i < k.entries.rows(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < k.entries.columns(); ++j) sum += std::abs(k.entries(i, j));
    norm = std::max(norm, sum);
  }
  EXPECT_GT(norm, 1);
  const auto found = find_contraction(k.entries, k.row_radius);
  ASSERT_TRUE(found);
  expect_contracts(k.entries, *found);
}

TEST(FindContraction, RefusesASpectralRadiusOfOneOrMore) {
  const auto two = find_contraction(two_by_two(0, 2, 1, 0));
  ASSERT_FALSE(two);
  EXPECT_NEAR(two.reason().theta, std::sqrt(2.0), 0.01);
  EXPECT_FALSE(find_contraction(two_by_two(0.5, 0.5, 0.5, 0.5)));
  EXPECT_FALSE(find_contraction(two_by_two(0, 0, 0, 1)));
  EXPECT_FALSE(find_contraction(two_by_two(0.5, 0.25, 0.25, 0.5), Values{0.25, 0.25}));
  EXPECT_TRUE(find_contraction(two_by_two(0.5, 0.25, 0.25, 0.5), Values{0.2, 0.2}));
}

TEST(FindContraction, RefusesWhatIsNotFinite) {
  for (const double odd : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    const auto found = find_contraction(two_by_two(0.1, odd, 0.1, 0.1));
    ASSERT_FALSE(found);
    EXPECT_EQ(found.reason().theta, infinity);
  }
}

TEST(FindContraction, RefusesMatricesAndRadiiOfAnotherShape) {
  EXPECT_THROW(static_cast<void>(find_contraction(Matrix<double>(2, 3))), ContractViolation);
  EXPECT_THROW(static_cast<void>(find_contraction(Matrix<double>())), ContractViolation);
  EXPECT_THROW(static_cast<void>(find_contraction(Matrix<double>(2, 2), Values{1})), ContractViolation);
}

TEST(FindContraction, StopsWhenAskedTo) {
  request_interruption();
  EXPECT_THROW(static_cast<void>(find_contraction(two_by_two(0, 0.5, 0.5, 0))), Interrupted);
  clear_interruption();
}

TEST(Contraction, BoundsTheInverseAndIsAttained) {
  std::mt19937_64 random(34);
  double sharpest = 0;
  for (const std::size_t n : {1U, 2U, 7U})
    for (const double row_sum : {0.3, 0.9, 1.1})
      for (int trial = 0; trial < 20; ++trial) {
        const Matrix<double> k = test::random_matrix(random, n, row_sum, trial % 2 == 0);
        const auto found = find_contraction(k);
        if (!found) continue;
        Values d = test::random_values(random, n);
        if (trial % 4 == 0) d.assign(found->weights().begin(), found->weights().end());
        const std::vector<Rational> x = test::exact_solution(k, d).value();
        const double norm = found->norm(d);
        const Rational bound = Rational::exactly(found->inverse_bound(norm));
        for (std::size_t i = 0; i < n; ++i) {
          EXPECT_LE(abs(Rational::exactly(d[i])),
                    Rational::exactly(norm) * Rational::exactly(found->weights()[i]));
          EXPECT_LE(abs(x[i]), bound);
          // In the norm itself: |x_i| <= bound w_i.
          EXPECT_LE(abs(x[i]), bound * Rational::exactly(found->weights()[i]));
          sharpest = std::max(sharpest, (abs(x[i]) / bound).to_double());
        }
      }
  EXPECT_GT(sharpest, 0.999);
}

TEST(Contraction, RoundsItsBoundsUp) {
  std::mt19937_64 random(36);
  for (int trial = 0; trial < 200; ++trial) {
    const auto found = find_contraction(two_by_two(0, std::abs(test::uniform(random)), 0.3, 0.1));
    if (!found) continue;
    const double norm = std::abs(test::uniform(random));
    const Rational least = Rational::exactly(norm) / (1 - Rational::exactly(found->theta()));
    EXPECT_GE(Rational::exactly(found->inverse_bound(norm)), least);
  }
}

TEST(Contraction, CallsVectorsInfiniteThatAreNotFinite) {
  const auto found = find_contraction(two_by_two(0.1, 0.2, 0.3, 0.1));
  ASSERT_TRUE(found);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(found->norm(Values{nan, 1}), infinity);
  EXPECT_EQ(found->norm(Values{1, nan}), infinity);
  EXPECT_EQ(found->norm(Values{-infinity, 1}), infinity);
  EXPECT_EQ(found->norm(Values{0, 0}), 0);
}

TEST(FindContraction, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(35);
  const Matrix<double> k = test::random_matrix(random, 600, 0.8, false);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const auto found = find_contraction(k).value();
    Values numbers(found.weights().begin(), found.weights().end());
    numbers.push_back(found.theta());
    return numbers;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

}  // namespace
}  // namespace radcert
