// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/elimination.h"
#include "radcert/solve/verified_system.h"
#include "systems.h"

namespace radcert {
namespace {

using test::matrix;
using test::random_matrix;
using test::random_values;
using test::uniform;
using test::Values;
using Digits = Mpfr<100>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<Digits> solution_in_digits(const Matrix<double>& k, const Values& e) {
  Matrix<Digits> fine(k.rows(), k.columns());
  for (std::size_t j = 0; j < k.columns(); ++j)
    for (std::size_t i = 0; i < k.rows(); ++i) fine(i, j) = Digits(k(i, j));
  std::vector<Digits> right;
  for (const double value : e) right.emplace_back(value);
  return solve_by_elimination(fine, std::move(right));
}

/// The first entry of u outside of the enclosure, or size().
std::size_t first_outside(const VerifiedSolution& enclosure, const std::vector<Digits>& u) {
  for (std::size_t i = 0; i < u.size(); ++i)
    if (!(abs(u[i] - Digits(enclosure.values[i])) <= Digits(enclosure.radius[i]))) return i;
  return u.size();
}

/// max_i sum_j |((I - K)^-1)_ij|, about.
double inverse_norm(const Matrix<double>& k) {
  const std::size_t n = k.rows();
  Values sums(n);
  for (std::size_t j = 0; j < n; ++j) {
    Values column(n);
    column[j] = 1;
    const std::vector<double> inverse = solve_by_elimination(k, column);
    for (std::size_t i = 0; i < n; ++i) sums[i] += std::abs(inverse[i]);
  }
  return *std::max_element(sums.begin(), sums.end());
}

/// max_i sum_j |(I - K)_ij|, about.
double norm(const Matrix<double>& k) {
  double largest = 0;
  for (std::size_t i = 0; i < k.rows(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < k.columns(); ++j) sum += std::abs((i == j ? 1.0 : 0.0) - k(i, j));
    largest = std::max(largest, sum);
  }
  return largest;
}

/// x - 2 v (v . x) for each column, v of unit length: a random reflection from the left.
void reflect(std::mt19937_64& random, Matrix<double>& a) {
  Values v = random_values(random, a.rows());
  double squares = 0;
  for (const double x : v) squares += x * x;
  for (std::size_t j = 0; j < a.columns(); ++j) {
    double along = 0;
    for (std::size_t i = 0; i < a.rows(); ++i) along += v[i] * a(i, j);
    for (std::size_t i = 0; i < a.rows(); ++i) a(i, j) -= 2 * along / squares * v[i];
  }
}

Matrix<double> transposed(const Matrix<double>& a) {
  return matrix(a.columns(), [&](std::size_t i, std::size_t j) { return a(j, i); });
}

/// I - A, A with singular values from 1 down to 1/condition.
Matrix<double> conditioned(std::mt19937_64& random, std::size_t n, double condition) {
  Matrix<double> a = matrix(n, [&](std::size_t i, std::size_t j) {
    const double place = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
    return i == j ? std::pow(condition, -place) : 0.0;
  });
  for (int side = 0; side < 2; ++side) {
    reflect(random, a);
    reflect(random, a);
    a = transposed(a);
  }
  return matrix(n, [&](std::size_t i, std::size_t j) { return (i == j ? 1.0 : 0.0) - a(i, j); });
}

struct Problem {
  Matrix<double> k;
  Values e;
};

/// Sizes to 60, conditions to 1e8, positive and signed K with row sums below and above 1.
Problem random_problem(std::mt19937_64& random, int trial) {
  constexpr std::size_t largest = 60;
  const std::size_t n = trial % 10 == 0 ? 1 + random() % 3 : 1 + random() % largest;
  if (trial % 2 == 0)
    return {conditioned(random, n, std::pow(10.0, static_cast<double>(random() % 9))),
            random_values(random, n)};
  constexpr std::array row_sums{0.3, 0.99, 1.5, 4.0};
  return {random_matrix(random, n, row_sums[random() % row_sums.size()], random() % 2 == 0),
          random_values(random, n)};
}

TEST(VerifiedSystem, EnclosesTheSolutionAndLittleElse) {
  std::mt19937_64 random(41);
  Values widths;
  for (int trial = 0; trial < 200; ++trial) {
    const auto [k, e] = random_problem(random, trial);
    const Outcome<VerifiedSystem> system = verified_system(k);
    ASSERT_TRUE(system.has_value()) << "trial " << trial << ": " << system.reason();
    EXPECT_LT(system->theta(), 1);
    const VerifiedSolution enclosure = system->solve(e).value();
    const std::vector<Digits> u = solution_in_digits(k, e);
    const std::size_t outside = first_outside(enclosure, u);
    EXPECT_EQ(outside, e.size()) << "trial " << trial << ", " << e.size() << " rows";
    const double condition = norm(k) * inverse_norm(k);
    double size = 0;
    for (const double value : enclosure.values) size = std::max(size, std::abs(value));
    for (std::size_t i = 0; i < e.size() && size > 0; ++i) {
      widths.push_back(enclosure.radius[i] / (epsilon * condition * size));
      // Refined until rounding the values to double is what remains.
      EXPECT_LE(enclosure.radius[i], 2 * epsilon * size) << "trial " << trial << ", condition " << condition;
    }
  }
  std::nth_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2),
                   widths.end());
  EXPECT_LT(widths[widths.size() / 2], 1);
}

/// What has been solved with exact data, and the same with radii.
struct Family {
  Problem middle;
  Matrix<double> k_radius;
  Values e_radius;

  /// One of its systems, its data moved by `share` of the radii in the directions of the signs.
  template <class MatrixSign, class VectorSign>
  Problem member(MatrixSign matrix_sign, VectorSign vector_sign) const {
    Problem moved = middle;
    for (std::size_t i = 0; i < moved.e.size(); ++i) {
      moved.e[i] += vector_sign(i) * e_radius[i];
      for (std::size_t j = 0; j < moved.e.size(); ++j) moved.k(i, j) += matrix_sign(i, j) * k_radius(i, j);
    }
    return moved;
  }
};

/// Data that are multiples of 2^-20, radii that are multiples of 2^-45: members are exact in double.
Family random_family(std::mt19937_64& random, std::size_t n) {
  const auto coarse = [](double x) { return std::nearbyint(x * 0x1p20) * 0x1p-20; };
  Family family;
  family.middle.k = random_matrix(random, n, 1.3, false);
  for (std::size_t j = 0; j < n; ++j)
    for (double& entry : family.middle.k.column(j)) entry = coarse(entry);
  family.middle.e = random_values(random, n);
  for (double& entry : family.middle.e) entry = coarse(entry);
  const int largest = 1 + static_cast<int>(random() % 1000);
  const auto radius = [&] {
    return random() % 4 == 0 ? 0.0 : static_cast<double>(random() % static_cast<unsigned>(largest)) * 0x1p-45;
  };
  family.k_radius = matrix(n, [&](std::size_t, std::size_t) { return radius(); });
  family.e_radius = Values(n);
  for (double& entry : family.e_radius) entry = radius();
  return family;
}

double sign_of(double x) { return x < 0 ? -1 : 1; }

TEST(VerifiedSystem, EnclosesTheSolutionsOfAllSystemsWithinTheRadiiAndIsReached) {
  std::mt19937_64 random(42);
  double least_reached = 1;
  for (int trial = 0; trial < 30; ++trial) {
    const std::size_t n = 1 + random() % 12;
    const Family family = random_family(random, n);
    const Outcome<VerifiedSystem> system = verified_system(family.middle.k, family.k_radius);
    ASSERT_TRUE(system.has_value()) << system.reason();
    const VerifiedSolution enclosure = system->solve(family.middle.e, family.e_radius).value();
    // The data that move entry `row` of the solution furthest, to first order.
    const std::size_t row = random() % n;
    Values of_row(n);
    of_row[row] = 1;
    const Values sensitivity = solve_by_elimination(transposed(family.middle.k), of_row);
    for (const double direction : {1.0, -1.0}) {
      const Problem worst = family.member(
          [&](std::size_t i, std::size_t j) {
            return direction * sign_of(sensitivity[i]) * sign_of(enclosure.values[j]);
          },
          [&](std::size_t i) { return direction * sign_of(sensitivity[i]); });
      const std::vector<Digits> u = solution_in_digits(worst.k, worst.e);
      EXPECT_EQ(first_outside(enclosure, u), n) << "trial " << trial << ", row " << row << " of " << n;
      const double moved = abs(u[row] - Digits(enclosure.values[row])).to_double();
      if (enclosure.radius[row] > 100 * epsilon * std::abs(enclosure.values[row]))
        least_reached = std::min(least_reached, moved / enclosure.radius[row]);
    }
    const Problem other =
        family.member([&](std::size_t, std::size_t) { return random() % 2 == 0 ? 1.0 : -1.0; },
                      [&](std::size_t) { return random() % 2 == 0 ? 1.0 : -1.0; });
    EXPECT_EQ(first_outside(enclosure, solution_in_digits(other.k, other.e)), n) << "trial " << trial;
  }
  EXPECT_GT(least_reached, 0.95);
  EXPECT_LT(least_reached, 1);
}

TEST(VerifiedSystem, EnclosesTheSolutionsOfWideFamilies) {
  // (1 - k) u = 1 with |k| <= r: u from 1 / (1 + r) to 1 / (1 - r); the enclosure is the smallest about 1.
  for (const double r : {0.5, 0.875, 1 - 0x1p-20}) {
    Matrix<double> radius(1, 1);
    radius(0, 0) = r;
    const VerifiedSolution enclosure =
        verified_system(Matrix<double>(1, 1), radius)->solve(Values{1}).value();
    EXPECT_EQ(enclosure.values[0], 1);
    EXPECT_GE(enclosure.radius[0], r / (1 - r));
    EXPECT_LE(enclosure.radius[0], r / (1 - r) * (1 + 1e-8));
  }
}

TEST(VerifiedSystem, RefusesFamiliesThatContainASingularMatrix) {
  Matrix<double> radius(1, 1);
  radius(0, 0) = 1;
  EXPECT_FALSE(verified_system(Matrix<double>(1, 1), radius).has_value());
  EXPECT_FALSE(verified_system(matrix(1, [](std::size_t, std::size_t) { return 1.0; })).has_value());
  // Whole numbers whose last row is a sum of the others: elimination seldom notices, and the rounding of R A
  // hides it.
  std::mt19937_64 random(43);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::size_t n = 2 + random() % 4;
    Matrix<double> a =
        matrix(n, [&](std::size_t, std::size_t) { return static_cast<double>(random() % 2001) - 1000; });
    for (std::size_t j = 0; j < n; ++j) {
      a(n - 1, j) = 0;
      for (std::size_t i = 0; i + 1 < n; ++i) a(n - 1, j) += (i % 2 == 0 ? 3 : -7) * a(i, j);
    }
    const Matrix<double> k =
        matrix(n, [&](std::size_t i, std::size_t j) { return (i == j ? 1.0 : 0.0) - a(i, j); });
    const Outcome<VerifiedSystem> exact = verified_system(k);
    EXPECT_FALSE(exact.has_value()) << "trial " << trial << ", theta " << exact->theta();
    // Moved away from the singular matrix by as much as the radii reach.
    const double r = std::ldexp(1.0, static_cast<int>(random() % 12) - 6);
    const Matrix<double> moved =
        matrix(n, [&](std::size_t i, std::size_t j) { return k(i, j) + (random() % 2 == 0 ? r : -r); });
    const Outcome<VerifiedSystem> wide =
        verified_system(moved, matrix(n, [&](std::size_t, std::size_t) { return r; }));
    EXPECT_FALSE(wide.has_value()) << "trial " << trial << ", theta " << wide->theta() << ", radius " << r;
  }
}

TEST(VerifiedSystem, CountsWhatTheResidualLoses) {
  // Row 0 is u_0 = u_1 + 2^-60 u_2 + 2^-120 u_3 - 2^-60 u_4 - u_5 with all five 1: exactly 2^-120, computed
  // as 0.
  Matrix<double> k(6, 6);
  const Values row{0, 1, 0x1p-60, 0x1p-120, -0x1p-60, -1};
  for (std::size_t j = 0; j < 6; ++j) k(0, j) = row[j];
  const VerifiedSolution enclosure = verified_system(k)->solve(Values{0, 1, 1, 1, 1, 1}).value();
  EXPECT_NE(enclosure.values[0], 0x1p-120);
  EXPECT_LE(std::abs(enclosure.values[0] - 0x1p-120), enclosure.radius[0]);
  EXPECT_LE(enclosure.radius[0], 0x1p-95);
}

TEST(VerifiedSystem, CountsWhatUnderflows) {
  // u_0 = 2^-540 u_1 = 2^-1080, which no double is.
  Matrix<double> k(2, 2);
  k(0, 1) = 0x1p-540;
  const VerifiedSolution enclosure = verified_system(k)->solve(Values{0, 0x1p-540}).value();
  EXPECT_GT(enclosure.radius[0], 0);
  EXPECT_LE(enclosure.radius[0], 0x1p-1000);
}

TEST(VerifiedSystem, CountsWhatUnderflowsInEveryProduct) {
  // u_0 is the sum of 100 products that lose half of the least number each, and u_1 is 1000 u_0.
  constexpr std::size_t n = 102;
  constexpr double factor = 0x1p-537;
  const double value = 1000.4921875 * factor;
  Matrix<double> k(n, n);
  Values e(n);
  k(1, 0) = 1000;
  for (std::size_t j = 2; j < n; ++j) {
    k(0, j) = factor;
    e[j] = value;
  }
  const VerifiedSolution enclosure = verified_system(k)->solve(e).value();
  const Rational u_0 = Rational(100) * Rational::exactly(factor) * Rational::exactly(value);
  EXPECT_LE(abs(1000 * u_0 - Rational::exactly(enclosure.values[1])), Rational::exactly(enclosure.radius[1]));
  EXPECT_LE(enclosure.radius[1], 0.01 * enclosure.values[1]);
}

TEST(VerifiedSystem, RoundsSumsOfSizesUp) {
  // u_0 is the sum of all, whose radii but the first are lost beside it, one by one.
  constexpr std::size_t n = 600;
  constexpr double lost = 0x1.fffffp-54;
  Matrix<double> k(n, n);
  Values radius(n, lost);
  radius[0] = 1;
  for (std::size_t j = 1; j < n; ++j) k(0, j) = 1;
  const VerifiedSolution enclosure = verified_system(k)->solve(Values(n), radius).value();
  EXPECT_GE(Rational::exactly(enclosure.radius[0]),
            1 + Rational(static_cast<long>(n - 1)) * Rational::exactly(lost));
  EXPECT_LE(enclosure.radius[0], 1 + 1e-9);
}

TEST(VerifiedSystem, CountsTheRoundingOfTheDiagonal) {
  // The inverse of 1 - 2^-60 is computed as 1, and 1 - (1 - 2^-60) as 0.
  Matrix<double> k(1, 1);
  k(0, 0) = 0x1p-60;
  EXPECT_GE(verified_system(k)->theta(), 0x1p-60);
}

TEST(VerifiedSystem, DoesNotMindTheScalingOfColumns) {
  std::mt19937_64 random(44);
  for (int trial = 0; trial < 20; ++trial) {
    const std::size_t n = 2 + random() % 20;
    const Matrix<double> plain = conditioned(random, n, 1e4);
    const auto power = [&] { return std::ldexp(1.0, 60 + static_cast<int>(random() % 200)); };
    Values columns(n);
    for (std::size_t i = 0; i < n; ++i) columns[i] = power();
    // I - K = A D: beside its entries the 1 of I is nothing.
    const Matrix<double> k = matrix(
        n, [&](std::size_t i, std::size_t j) { return -((i == j ? 1.0 : 0.0) - plain(i, j)) * columns[j]; });
    const Values e = random_values(random, n);
    const Outcome<VerifiedSystem> system = verified_system(k);
    ASSERT_TRUE(system.has_value()) << system.reason();
    EXPECT_LT(system->theta(), 1e-6);
    const VerifiedSolution enclosure = system->solve(e).value();
    EXPECT_EQ(first_outside(enclosure, solution_in_digits(k, e)), n) << "trial " << trial;
  }
  // Columns scaled alone: every entry of the solution keeps its digits.
  const Matrix<double> k = matrix(3, [](std::size_t i, std::size_t j) {
    const double scale = std::ldexp(1.0, 300 * static_cast<int>(j));
    return (i == j ? 1.0 : 0.0) - scale * (i == j ? 4.0 : 1.0);
  });
  const Outcome<VerifiedSystem> system = verified_system(k);
  ASSERT_TRUE(system.has_value()) << system.reason();
  EXPECT_LT(system->theta(), 1e-10);
  const VerifiedSolution enclosure = system->solve(Values{6, 6, 6}).value();
  EXPECT_EQ(first_outside(enclosure, solution_in_digits(k, {6, 6, 6})), 3);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LE(enclosure.radius[i], 4 * epsilon * std::abs(enclosure.values[i])) << i;
}

TEST(VerifiedSystem, SolvesCollocationSystemsBeyondContraction) {
  // A reflectivity above 1: no norm of |K| is below 1, and the equations are regular all the same.
  const CollocationMatrix<double> collocation = test::collocation_matrix("ellipsoid", 1, 1, 1.5);
  const std::size_t n = collocation.entries.rows();
  EXPECT_FALSE(find_contraction(collocation.entries).has_value());
  const Outcome<VerifiedSystem> system = verified_system(collocation.entries);
  ASSERT_TRUE(system.has_value()) << system.reason();
  EXPECT_LT(system->theta(), 1e-9);
  std::mt19937_64 random(45);
  const Values e = random_values(random, n);
  const VerifiedSolution enclosure = system->solve(e).value();
  EXPECT_EQ(first_outside(enclosure, solution_in_digits(collocation.entries, e)), n);
}

TEST(VerifiedSystem, ProvesTheCollocationSolutionOfATetrahedron) {
  // In an enclosure of constant reflectivity 1/2 and constant emission 1 the rows of K_n have the sum 1/2: u
  // = 2 exactly.
  const Vector<Rational> a{Rational(0), Rational(1, 3), Rational(0)};
  const Vector<Rational> b{Rational(1), Rational(0), Rational(1, 7)};
  const Vector<Rational> c{Rational(1, 5), Rational(1), Rational(0)};
  const Vector<Rational> d{Rational(1, 2), Rational(1, 2), Rational(4, 5)};
  const std::vector<ExactTriangle> sides{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(1, Rational(1, 6))).value();
  const Outcome<CertifiedEntries> k = certified_entries(sides, functions, Values(12, 0.5));
  ASSERT_TRUE(k.has_value()) << k.reason();
  const VerifiedSolution enclosure =
      verified_system(k->entries, k->radius).value().solve(Values(12, 1.0)).value();
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_LE(std::abs(enclosure.values[i] - 2), enclosure.radius[i]) << i;
    EXPECT_LE(enclosure.radius[i], 2e-13) << i;
  }
}

TEST(VerifiedSystem, IsExactForTheIdentity) {
  const VerifiedSolution enclosure = verified_system(Matrix<double>(3, 3))->solve(Values{3, -5, 0}).value();
  EXPECT_EQ(enclosure.values, (Values{3, -5, 0}));
  for (const double radius : enclosure.radius) EXPECT_LE(radius, 1e-29);
}

TEST(VerifiedSystem, HasTheSameBitsForEveryNumberOfThreads) {
  std::mt19937_64 random(46);
  constexpr std::size_t n = 300;
  const Matrix<double> k = random_matrix(random, n, 2.0, false);
  const Values e = random_values(random, n);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const VerifiedSystem system = verified_system(k).value();
    const VerifiedSolution enclosure = system.solve(e).value();
    Values numbers = enclosure.values;
    numbers.insert(numbers.end(), enclosure.radius.begin(), enclosure.radius.end());
    numbers.push_back(system.theta());
    return numbers;
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(VerifiedSystem, RefusesNumbersBeyondTheLargest) {
  Matrix<double> k(1, 1);
  k(0, 0) = 1 - 0x1p-40;
  const Outcome<VerifiedSystem> system = verified_system(k);
  ASSERT_TRUE(system.has_value());
  EXPECT_FALSE(system->solve(Values{0x1p1020}).has_value());
}

TEST(VerifiedSystem, RefusesDataThatAreNone) {
  EXPECT_THROW(static_cast<void>(verified_system(Matrix<double>(2, 3))), ContractViolation);
  EXPECT_THROW(static_cast<void>(verified_system(Matrix<double>())), ContractViolation);
  EXPECT_THROW(static_cast<void>(verified_system(Matrix<double>(2, 2), Matrix<double>(1, 1))),
               ContractViolation);
  const auto constant = [](double value) {
    return matrix(1, [value](std::size_t, std::size_t) { return value; });
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(verified_system(constant(infinity))), ContractViolation);
  EXPECT_THROW(static_cast<void>(verified_system(constant(0), constant(-1))), ContractViolation);
  EXPECT_THROW(static_cast<void>(verified_system(constant(0), constant(infinity))), ContractViolation);
  const VerifiedSystem system = verified_system(constant(0)).value();
  EXPECT_THROW(static_cast<void>(system.solve(Values{1, 2})), ContractViolation);
  EXPECT_THROW(static_cast<void>(system.solve(Values{infinity})), ContractViolation);
  EXPECT_THROW(static_cast<void>(system.solve(Values{1}, Values{-1})), ContractViolation);
  EXPECT_THROW(static_cast<void>(system.solve(Values{1}, Values{1, 1})), ContractViolation);
}

}  // namespace
}  // namespace radcert
