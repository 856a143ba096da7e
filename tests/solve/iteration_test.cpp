// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/iteration.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/kept_numbers.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/real.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/solve/neumann.h"
#include "radcert/solve/rounding/accurate_dot.h"
#include "tests/solve/systems.h"

namespace radcert {
namespace {

using test::Values;

constexpr double unit = unit_roundoff<double>();

/// Each of the solvers that iterate.
class Iteration : public testing::TestWithParam<std::string> {
protected:
  static Outcome<IterativeSolution, NotReached> solve(const SystemProducts& k, const Contraction& contraction,
                                                      const Values& e, std::optional<double> tolerance) {
    return find_linear_solver(GetParam())->iterate(k, contraction, e, tolerance, nullptr);
  }
  static Outcome<IterativeSolution, NotReached> solve(const Matrix<double>& k, const Values& e,
                                                      std::optional<double> tolerance = std::nullopt) {
    return solve(k, find_contraction(k).value(), e, tolerance);
  }
};

INSTANTIATE_TEST_SUITE_P(All, Iteration, testing::ValuesIn(solver_names([](const LinearSolver& solver) {
                           return solver.iterates() && !solver.on_ranks;
                         })),
                         [](const auto& solver) { return solver.param; });

/// What is left where nothing is demanded: 4 u (1 + theta)/(1 - theta)^2 by theory, in the contraction's own
/// norm.
double rounding_bound(const Contraction& contraction, const Values& v) {
  const double theta = contraction.theta();
  return 4.01 * unit * (1 + theta) / ((1 - theta) * (1 - theta)) * contraction.norm(v);
}

TEST_P(Iteration, BoundsItsErrorOnRandomMatrices) {
  std::mt19937_64 random(41);
  for (const std::size_t n : {1U, 2U, 3U, 17U, 80U, 150U})
    for (const double row_sum : {0.0, 0.2, 0.7, 0.95})
      for (const bool positive : {true, false}) {
        const Matrix<double> k = test::random_matrix(random, n, row_sum, positive);
        const Values e = test::random_values(random, n);
        const Contraction contraction = find_contraction(k).value();
        const auto solution = solve(k, contraction, e, std::nullopt);
        ASSERT_TRUE(solution) << n << " " << row_sum;
        const double reference = test::long_rounding(contraction.theta(), test::max_abs(solution->values));
        EXPECT_LE(test::largest_error(test::long_solution(k, e), solution->values),
                  solution->error_bound + reference)
            << n << " " << row_sum;
        EXPECT_LE(solution->error_bound, rounding_bound(contraction, solution->values))
            << n << " " << row_sum;
      }
}

TEST_P(Iteration, BoundsItsErrorExactly) {
  // Against rational numbers, where not even the reference rounds.
  std::mt19937_64 random(42);
  for (const std::size_t n : {1U, 2U, 5U, 9U})
    for (const double row_sum : {0.5, 0.9, 1.1})
      for (int trial = 0; trial < 6; ++trial) {
        const Matrix<double> k = test::random_matrix(random, n, row_sum, trial % 2 == 0);
        const auto contraction = find_contraction(k);
        if (!contraction) continue;
        const Values e = test::random_values(random, n);
        const std::vector<Rational> u = test::exact_solution(k, e).value();
        for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(1e-3)}) {
          const auto solution = solve(k, *contraction, e, tolerance);
          ASSERT_TRUE(solution);
          for (std::size_t i = 0; i < n; ++i)
            EXPECT_LE(abs(u[i] - Rational::exactly(solution->values[i])),
                      Rational::exactly(solution->error_bound));
        }
      }
}

TEST_P(Iteration, AgreesWithEliminationOnCollocationMatrices) {
  std::mt19937_64 random(43);
  for (const char* surface : {"cube", "two_piece", "sphere"})
    for (int degree = 0; degree <= 2; ++degree)
      for (int level = 0; level <= (degree == 2 ? 0 : 1); ++level)
        for (const double rho : {0.3, 0.9}) {
          SCOPED_TRACE(std::string(surface) + " degree " + std::to_string(degree) + " level " +
                       std::to_string(level) + " rho " + std::to_string(rho));
          const CollocationMatrix<double> k = test::collocation_matrix(surface, level, degree, rho);
          const Contraction contraction = find_contraction(k.entries, k.row_radius).value();
          const Values e = test::random_values(random, k.entries.rows());
          const auto solution = solve(k.entries, contraction, e, std::nullopt);
          ASSERT_TRUE(solution);
          const double size = test::max_abs(solution->values);
          const double error = test::largest_error(test::long_solution(k.entries, e), solution->values);
          EXPECT_LE(error, solution->error_bound);
          // The bound is not idle: a factor to the error itself, and to what rounding u to double leaves of
          // it.
          EXPECT_LE(solution->error_bound, 50 * error);
          EXPECT_LE(solution->error_bound, 4 / (1 - contraction.theta()) * unit * size);
          const Values direct = DirectSolver(k.entries).solve(e);
          for (std::size_t i = 0; i < direct.size(); ++i)
            EXPECT_NEAR(solution->values[i], direct[i], 1e-13 / (1 - contraction.theta()) * size);
        }
}

TEST_P(Iteration, KeepsToTheTolerance) {
  std::mt19937_64 random(44);
  for (const double row_sum : {0.3, 0.9, 0.99}) {
    const Matrix<double> k = test::random_matrix(random, 100, row_sum, true);
    const Values e = test::random_values(random, 100);
    const std::vector<long double> u = test::long_solution(k, e);
    std::size_t before = 0;
    for (const double tolerance : {0.5, 1e-2, 1e-5, 1e-9, 1e-12}) {
      const auto solution = solve(k, e, tolerance);
      ASSERT_TRUE(solution) << row_sum << " " << tolerance;
      EXPECT_LE(solution->error_bound, tolerance * test::max_abs(solution->values));
      EXPECT_LE(test::largest_error(u, solution->values), solution->error_bound);
      EXPECT_GE(solution->iterations, before) << "a smaller tolerance";
      before = solution->iterations;
    }
    const auto coarse = solve(k, e, 1e-2);
    EXPECT_GT(test::largest_error(u, coarse->values), 1e-14) << "it stops where it may";
    EXPECT_LT(coarse->iterations, before);
  }
}

/// A row-stochastic matrix times 0.999: the rounding of u alone gives a bound of about 1000 u.
Matrix<double> nearly_stochastic(std::mt19937_64& random) {
  Matrix<double> k =
      test::matrix(30, [&](std::size_t, std::size_t) { return 1 + test::uniform(random) / 2; });
  for (std::size_t i = 0; i < 30; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 30; ++j) sum += k(i, j);
    for (std::size_t j = 0; j < 30; ++j) k(i, j) *= 0.999 / sum;
  }
  return k;
}

TEST_P(Iteration, SaysSoWhereTheToleranceIsOutOfReach) {
  std::mt19937_64 random(45);
  const Matrix<double> k = nearly_stochastic(random);
  const Values e = test::random_values(random, 30);
  const auto demanded = solve(k, e, least_tolerance);
  ASSERT_FALSE(demanded);
  EXPECT_GT(demanded.reason().error_bound, least_tolerance * demanded.reason().size);
  EXPECT_LT(demanded.reason().error_bound, 1e-9 * demanded.reason().size) << "it came as far as double holds";
  EXPECT_GT(demanded.reason().iterations, 0U);
  const auto rounded = solve(k, e);
  ASSERT_TRUE(rounded);
  EXPECT_LE(test::largest_error(test::long_solution(k, e), rounded->values), rounded->error_bound);
  EXPECT_LT(rounded->error_bound, 1e-10 * test::max_abs(rounded->values));
}

TEST_P(Iteration, NeverCallsAnOverflowASolution) {
  // u = 10 e is beyond the largest number.
  Matrix<double> k(3, 3);
  for (std::size_t i = 0; i < 3; ++i) k(i, (i + 1) % 3) = 0.9;
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(0.5)}) {
    const auto solution = solve(k, Values(3, 1e308), tolerance);
    if (solution) {
      ADD_FAILURE() << solution->values[0] << " +- " << solution->error_bound;
    }
  }
  EXPECT_FALSE(solve(k, Values{std::numeric_limits<double>::infinity(), 1, 1}));
  EXPECT_FALSE(solve(k, Values{1, std::numeric_limits<double>::quiet_NaN(), 1}));
}

TEST_P(Iteration, IsExactWhereItCanBe) {
  const auto nothing = solve(Matrix<double>(4, 4), Values{1, -2, 3, 0.1});
  ASSERT_TRUE(nothing);
  EXPECT_EQ(nothing->values, (Values{1, -2, 3, 0.1}));
  std::mt19937_64 random(46);
  const auto dark = solve(test::random_matrix(random, 50, 0.9, false), Values(50));
  ASSERT_TRUE(dark);
  EXPECT_EQ(dark->values, Values(50));
  EXPECT_EQ(dark->error_bound, 0);
  EXPECT_EQ(dark->iterations, 0U);
}

TEST_P(Iteration, ScalesWithTheRightHandSide) {
  std::mt19937_64 random(47);
  const Matrix<double> k = test::random_matrix(random, 40, 0.8, false);
  const Values e = test::random_values(random, 40);
  const auto one = solve(k, e);
  for (const int power : {-900, -30, 30, 1000}) {
    Values scaled = e;
    for (double& value : scaled) value = std::ldexp(value, power);
    const auto solution = solve(k, scaled);
    ASSERT_TRUE(solution) << power;
    for (std::size_t i = 0; i < e.size(); ++i)
      EXPECT_NEAR(std::ldexp(solution->values[i], -power), one->values[i], 1e-14) << power;
    EXPECT_LT(std::ldexp(solution->error_bound, -power), 1e-14) << power;
  }
}

TEST_P(Iteration, FindsItsWayThroughACycleLongerThanItsMemory) {
  // 0.95 times a cyclic permutation: no polynomial of a degree below n does better than the Neumann series.
  constexpr std::size_t n = 300;
  Matrix<double> k(n, n);
  for (std::size_t i = 0; i < n; ++i) k(i, (i + 1) % n) = 0.95;
  Values e(n);
  e[7] = 1;
  const auto solution = solve(k, e);
  ASSERT_TRUE(solution);
  EXPECT_LE(test::largest_error(test::long_solution(k, e), solution->values), solution->error_bound);
  EXPECT_LT(solution->error_bound, 1e-13);
  EXPECT_GT(solution->iterations, krylov_dimension.count());
}

TEST_P(Iteration, BoundsItsErrorWhereRowSumsExceedOne) {
  // The plain rule residual/(1 - ||K||) says nothing: a triangular matrix with a row sum of 20.
  std::mt19937_64 random(48);
  const Matrix<double> k = test::matrix(20, [&](std::size_t i, std::size_t j) {
    return j > i ? 2 * test::uniform(random) / (1 + static_cast<double>(i)) : j == i ? 0.3 : 0;
  });
  const auto contraction = find_contraction(k);
  ASSERT_TRUE(contraction);
  const Values e = test::random_values(random, 20);
  const auto solution = solve(k, *contraction, e, 1e-8);
  ASSERT_TRUE(solution);
  EXPECT_LE(test::largest_error(test::long_solution(k, e), solution->values), solution->error_bound);
  EXPECT_LE(solution->error_bound, 1e-8 * test::max_abs(solution->values));
}

TEST_P(Iteration, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(49);
  const Matrix<double> k = test::random_matrix(random, 600, 0.9, false);
  const Values e = test::random_values(random, 600);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const auto solution = solve(k, e);
    Values numbers = solution->values;
    numbers.push_back(solution->error_bound);
    numbers.push_back(static_cast<double>(solution->iterations));
    return numbers;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST_P(Iteration, StopsWhenAskedTo) {
  const Matrix<double> k = test::matrix(4, [](std::size_t, std::size_t) { return 0.2; });
  const Contraction contraction = find_contraction(k).value();
  request_interruption();
  EXPECT_THROW(static_cast<void>(solve(k, contraction, Values(4, 1), std::nullopt)), Interrupted);
  clear_interruption();
}

/// Keeps numbers, and stops the work after so many times.
class StoppingMemory final : public KeptNumbers {
public:
  explicit StoppingMemory(int times) : left_(times) {}
  std::optional<std::vector<double>> find(const std::string& name) override {
    const auto at = numbers_.find(name);
    return at == numbers_.end() ? std::nullopt : std::optional(at->second);
  }
  void keep(const std::string& name, std::span<const double> kept) override {
    numbers_[name].assign(kept.begin(), kept.end());
    if (--left_ == 0) throw Interrupted();
  }

private:
  std::map<std::string, std::vector<double>> numbers_;
  int left_;
};

TEST_P(Iteration, GoesOnFromWhatItKeptAsIfItHadNotStopped) {
  // Where it reaches its goal, and where it gives up: after as many corrections as without a stop.
  std::mt19937_64 random(51);
  const Matrix<double> k = nearly_stochastic(random);
  const Contraction contraction = find_contraction(k).value();
  const Values e = test::random_values(random, 30);
  int stopped = 0;
  for (const double tolerance : {1e-3, least_tolerance}) {
    const auto run = [&](KeptNumbers* kept) {
      return find_linear_solver(GetParam())->iterate(k, contraction, e, tolerance, kept);
    };
    const auto whole = run(nullptr);
    EXPECT_EQ(whole.has_value(), tolerance > least_tolerance);
    for (const int times : {1, 2, 3, 40}) {
      StoppingMemory memory(times);
      try {
        static_cast<void>(run(&memory));
      } catch (const Interrupted&) {
        ++stopped;
      }
      const auto rest = run(&memory);
      ASSERT_EQ(rest.has_value(), whole.has_value()) << times;
      if (whole) {
        EXPECT_EQ(rest->values, whole->values) << times;
        EXPECT_EQ(rest->iterations, whole->iterations) << times;
        EXPECT_EQ(rest->error_bound, whole->error_bound) << times;
      } else {
        EXPECT_EQ(rest.reason().iterations, whole.reason().iterations) << times;
        EXPECT_EQ(rest.reason().error_bound, whole.reason().error_bound) << times;
        EXPECT_EQ(rest.reason().size, whole.reason().size) << times;
      }
    }
  }
  EXPECT_GE(stopped, 2);
}

TEST_P(Iteration, RefusesWhatDoesNotFit) {
  const Matrix<double> k = test::matrix(4, [](std::size_t, std::size_t) { return 0.2; });
  EXPECT_THROW(static_cast<void>(solve(k, Values(3, 1))), ContractViolation);
  EXPECT_THROW(static_cast<void>(solve(k, Values(4, 1), least_tolerance / 2)), ContractViolation);
  EXPECT_THROW(static_cast<void>(solve(k, Values(4, 1), 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(solve(k, Values(4, 1), std::numeric_limits<double>::quiet_NaN())),
               ContractViolation);
}

TEST_P(Iteration, TakesNoMoreStepsThanItsContractionPlans) {
  std::mt19937_64 random(50);
  for (const double row_sum : {0.2, 0.6, 0.9}) {
    const Matrix<double> k = test::random_matrix(random, 60, row_sum, true);
    const Contraction contraction = find_contraction(k).value();
    const Values e(60, 1.0);
    for (const double tolerance : {1e-3, 1e-6, 1e-12}) {
      const auto solution = solve(k, contraction, e, tolerance);
      ASSERT_TRUE(solution);
      // ||r_m||_w <= theta^(m+1) ||e||_w must fall to (1 - theta) tolerance |v|, |v| >= 1.
      const double goal = (1 - contraction.theta()) * tolerance / contraction.norm(e);
      const double steps = std::log(goal) / std::log(contraction.theta());
      EXPECT_LE(static_cast<double>(solution->iterations), std::ceil(steps)) << row_sum << " " << tolerance;
    }
  }
}

TEST(Gmres, NeedsFewerProductsThanTheNeumannSeries) {
  const CollocationMatrix<double> k = test::collocation_matrix("cube", 1, 1, 0.9);
  const Contraction contraction = find_contraction(k.entries).value();
  std::mt19937_64 random(51);
  const Values rough = test::random_values(random, k.entries.rows());
  const std::size_t neumann = solve_by_neumann(k.entries, contraction, rough).value().iterations;
  const std::size_t gmres = solve_by_gmres(k.entries, contraction, rough).value().iterations;
  EXPECT_LT(5 * gmres, neumann) << gmres << " against " << neumann;
}

TEST(ResidualBounds, BoundTheExactResidual) {
  std::mt19937_64 random(52);
  for (const std::size_t n : {1U, 4U, 30U}) {
    const Matrix<double> k = test::random_matrix(random, n, 0.9, false);
    const Contraction contraction = find_contraction(k).value();
    const Values e = test::random_values(random, n);
    const Values v = solve_by_gmres(k, contraction, e).value().values;
    Values r(n);
    accurate_residual(k, v, e, r);
    const Values bounds = residual_bounds(k, contraction, v, e, r);
    for (std::size_t i = 0; i < n; ++i) {
      Rational exact = Rational::exactly(e[i]) - Rational::exactly(v[i]);
      for (std::size_t j = 0; j < n; ++j) exact += Rational::exactly(k(i, j)) * Rational::exactly(v[j]);
      EXPECT_LE(abs(exact), Rational::exactly(bounds[i]));
      EXPECT_LE(Rational::exactly(bounds[i]), abs(exact) * Rational(1001, 1000) + Rational::exactly(1e-28));
    }
  }
}

/// The exact residual, entry by entry, within the bounds of the computed one.
void expect_bounded_residual(const Matrix<double>& k, const Values& v, const Values& e) {
  const Contraction contraction = find_contraction(k).value();
  Values r(v.size());
  accurate_residual(k, v, e, r);
  const Values bounds = residual_bounds(k, contraction, v, e, r);
  for (std::size_t i = 0; i < v.size(); ++i) {
    Rational exact = Rational::exactly(e[i]) - Rational::exactly(v[i]);
    for (std::size_t j = 0; j < v.size(); ++j) exact += Rational::exactly(k(i, j)) * Rational::exactly(v[j]);
    EXPECT_LE(abs(exact), Rational::exactly(bounds[i])) << i;
  }
}

TEST(ResidualBounds, CountTheRoundingOfALargeResidual) {
  std::mt19937_64 random(53);
  for (int trial = 0; trial < 20; ++trial)
    expect_bounded_residual(test::random_matrix(random, 3, 0.9, false), test::random_values(random, 3),
                            test::random_values(random, 3));
}

TEST(ResidualBounds, CountWhatCancelsInAProduct) {
  // Row 0 is 2^-2 (1 + 2^-60 + 2^-120 - 2^-60 - 1), computed as 0, of a v that is 0 there.
  Matrix<double> k(6, 6);
  const Values row{0, 0.25, 0x1p-62, 0x1p-122, -0x1p-62, -0.25};
  for (std::size_t j = 0; j < 6; ++j) k(0, j) = row[j];
  expect_bounded_residual(k, {0, 1, 1, 1, 1, 1}, {0, 1, 1, 1, 1, 1});
}

TEST(ResidualBounds, CountWhatUnderflows) {
  Matrix<double> k(2, 2);
  k(0, 1) = 0x1p-540;
  expect_bounded_residual(k, {0, 0x1p-540}, {0, 0x1p-540});
}

/// Half of the identity, said to be off by a millionth.
class HalfOfAll final : public ProductOperator {
public:
  [[nodiscard]] std::size_t size() const override { return 2; }
  void multiply(std::span<const double> x, std::span<double> y) const override {
    for (std::size_t i = 0; i < 2; ++i) y[i] = x[i] / 2;
  }
  void multiply_sizes(std::span<const double> x, std::span<double> y) const override { multiply(x, y); }
  void multiply_accurately(std::span<const double> x, std::span<double> y) const override { multiply(x, y); }
  [[nodiscard]] double rounding() const override { return 1e-6; }
};

TEST(ResidualBounds, CountWhatAnOperatorIsOffBy) {
  const HalfOfAll half;
  const Contraction contraction = find_contraction(half).value();
  const Values bounds = residual_bounds(half, contraction, Values{2, 8}, Values{1, 4}, Values{0, 0});
  for (const double bound : bounds) EXPECT_NEAR(bound, 8e-6, 1e-12);
}

}  // namespace
}  // namespace radcert
