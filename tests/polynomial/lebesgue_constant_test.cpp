// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/lebesgue_constant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

const Rational ten_digits(1, 10000000000L);

struct Location {
  double t = 0;
  double s = 0;
};

// sum |l_k| at the lattice of degree r pulled in by `inset`, by products of differences and in double: no
// Bernstein polynomials, no matrix.
double lattice_lebesgue_function(int r, double inset, const Location& x) {
  const std::array<double, 3> y{1 - x.s - x.t, x.t, x.s};
  double sum = 0;
  for (const std::array<int, 3>& k : lattice_indices(r)) {
    double product = 1;
    for (std::size_t i = 0; i < 3; ++i)
      for (int a = 0; a < k[i]; ++a) product *= (r * (y[i] - inset) / (1 - 3 * inset) - a) / (k[i] - a);
    sum += std::abs(product);
  }
  return sum;
}

// The largest value found on a lattice of points, then uphill from there by ever smaller steps: from below,
// but for rounding.
template <class F>
double largest_sample(const F& f) {
  constexpr int parts = 120;
  Location best;
  double value = 0;
  const auto look_at = [&](const Location& x) {
    if (x.s < 0 || x.t < 0 || x.s + x.t > 1 || f(x) <= value) return false;
    value = f(x);
    best = x;
    return true;
  };
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) look_at({i / double{parts}, j / double{parts}});
  for (double step = 0.01; step > 1e-9; step /= 2) {
    bool moved = true;
    while (moved) {
      moved = false;
      const Location from = best;
      for (const double ds : {-step, 0.0, step})
        for (const double dt : {-step, 0.0, step}) moved = look_at({from.t + dt, from.s + ds}) || moved;
    }
  }
  return value;
}

void expect_enclosed(double sampled, const LebesgueConstant& found, const std::string& title) {
  EXPECT_TRUE(found.reached) << title;
  EXPECT_LE(found.upper - found.lower, ten_digits) << title;
  const double rounding = 1e-11 * sampled;
  EXPECT_LE(sampled, found.upper.to_double() + rounding) << title;
  EXPECT_NEAR(sampled, found.lower.to_double(), 2e-10 + rounding) << title;
}

TEST(LebesgueConstant, OfTheEquispacedLatticeIsWhatSamplesReach) {
  // To two decimals these are the printed 1, 1.67, 2.27, 3.47, 5.45, 8.75, 14.3, 24.0, 40.9, 70.9.
  const std::vector<double> printed{1, 1.67, 2.27, 3.47, 5.45, 8.75, 14.34, 24.01, 40.92, 70.89};
  for (int r = 1; r <= 10; ++r) {
    const LebesgueConstant found = lebesgue_constant(functions_of(inset_nodes(r, Rational(0))), ten_digits);
    const double sampled =
        largest_sample([r](const Location& x) { return lattice_lebesgue_function(r, 0, x); });
    expect_enclosed(sampled, found, "degree " + std::to_string(r));
    EXPECT_NEAR(found.upper.to_double(), printed[static_cast<std::size_t>(r) - 1], 0.00501) << r;
    const Location near{found.near.x[1], found.near.x[2]};
    EXPECT_NEAR(lattice_lebesgue_function(r, 0, near), found.lower.to_double(), 1e-9);
  }
}

TEST(LebesgueConstant, OfInsetLatticesIsWhatSamplesReach) {
  for (int r = 2; r <= 7; ++r)
    for (const Rational& inset : {Rational(1, 50), Rational(1, 25), Rational(1, 6)}) {
      const LebesgueConstant found = lebesgue_constant(functions_of(inset_nodes(r, inset)), ten_digits);
      const double a = inset.to_double();
      const double sampled =
          largest_sample([&](const Location& x) { return lattice_lebesgue_function(r, a, x); });
      expect_enclosed(sampled, found, "degree " + std::to_string(r) + ", inset " + inset.to_text());
    }
}

TEST(LebesgueConstant, OfScatteredNodesIsWhatSamplesReach) {
  for (const int r : {1, 2, 3}) {
    const LagrangeFunctions functions = functions_of(scattered_nodes(r, 17));
    const LebesgueConstant found = lebesgue_constant(functions, ten_digits);
    EXPECT_TRUE(found.reached);
    Rational largest = 0;
    std::vector<Rational> values(functions.size());
    constexpr long parts = 40;
    for (long i = 0; i <= parts; ++i)
      for (long j = 0; i + j <= parts; ++j) {
        functions.values(at(Rational(i, parts), Rational(j, parts)), values);
        Rational sum = 0;
        for (const Rational& value : values) sum += abs(value);
        largest = std::max(largest, sum);
      }
    EXPECT_LE(largest, found.upper) << r;
    EXPECT_GE(largest, found.lower * Rational(99, 100)) << r;
  }
}

TEST(LebesgueConstant, IsKnownExactlyInSmallCases) {
  const auto contains = [](const LebesgueConstant& found, const Rational& value) {
    return found.lower <= value && value <= found.upper;
  };
  EXPECT_TRUE(contains(lebesgue_constant(functions_of(inset_nodes(0, Rational(0))), ten_digits), 1));
  EXPECT_TRUE(contains(lebesgue_constant(functions_of(inset_nodes(1, Rational(0))), ten_digits), 1));
  // Midpoints and vertices: 5/3 at the centroid.
  EXPECT_TRUE(
      contains(lebesgue_constant(functions_of(inset_nodes(2, Rational(0))), ten_digits), Rational(5, 3)));
  // Midpoints alone: the values at a vertex are -1, 1, 1.
  const Rational half(1, 2);
  EXPECT_TRUE(
      contains(lebesgue_constant(functions_of({at(half, half), at(0, half), at(half, 0)}), ten_digits), 3));
}

TEST(LebesgueConstant, OfLinearInterpolationIsARationalFunctionOfTheInset) {
  const InsetFunction exact = linear_lebesgue_constant();
  EXPECT_EQ(exact.numerator, RationalPolynomial::variable() + 1);
  EXPECT_EQ(exact.pole_order, 1);
  EXPECT_EQ(exact(Rational(1, 6)), Rational(7, 3));
  for (const Rational& inset : some_insets()) {
    const LebesgueConstant found = lebesgue_constant(functions_of(inset_nodes(1, inset)), ten_digits);
    EXPECT_TRUE(found.lower <= exact(inset) && exact(inset) <= found.upper) << inset.to_text();
  }
}

// Where the search goes on to two dozen digits, halving rounds a coefficient some hundred times, downwards
// each time. The corner at which it ends has dyadic coordinates, and there the sum is known exactly. Of the
// sets that were tried these are those whose roundings add up.
TEST(LebesgueConstant, IsNotAboveTheSumAtItsPoint) {
  for (const Nodes& nodes : {inset_nodes(3, Rational(1, 50)), inset_nodes(7, Rational(0)),
                             scattered_nodes(3, 4), scattered_nodes(4, 3), scattered_nodes(4, 6)}) {
    const LagrangeFunctions functions = functions_of(nodes);
    const LebesgueConstant found = lebesgue_constant(functions, 1 / power(Rational(10), 24));
    EXPECT_TRUE(found.reached);
    Barycentric<Rational> near;
    for (std::size_t i = 0; i < 3; ++i) near.x[i] = Rational::exactly(found.near.x[i]);
    std::vector<Rational> values(functions.size());
    functions.values(near, values);
    Rational sum = 0;
    for (const Rational& value : values) sum += abs(value);
    EXPECT_LE(found.lower, sum) << nodes.size();
    EXPECT_LE(sum, found.upper) << nodes.size();
  }
}

TEST(LebesgueConstant, DoesNotDependOnTheOrderOfTheNodes) {
  Nodes nodes = inset_nodes(4, Rational(1, 40));
  const LebesgueConstant one = lebesgue_constant(functions_of(nodes), ten_digits);
  std::reverse(nodes.begin(), nodes.end());
  const LebesgueConstant other = lebesgue_constant(functions_of(nodes), ten_digits);
  EXPECT_LE(one.lower, other.upper);
  EXPECT_LE(other.lower, one.upper);
}

TEST(LebesgueConstant, StaysEnclosedWhereTheSearchIsCutShort) {
  const LagrangeFunctions functions = functions_of(inset_nodes(6, Rational(0)));
  const LebesgueConstant narrow = lebesgue_constant(functions, ten_digits);
  for (const long limit : {1L, 2L, 10L, 100L}) {
    const LebesgueConstant wide = lebesgue_constant(functions, ten_digits, limit);
    EXPECT_FALSE(wide.reached);
    EXPECT_LE(wide.triangles, limit + 1);
    EXPECT_TRUE(wide.lower <= narrow.lower && narrow.upper <= wide.upper + ten_digits) << limit;
  }
  // A tolerance that the scaled integers cannot resolve ends the search as well.
  const LebesgueConstant finest = lebesgue_constant(functions, Rational(1, 1L << 62) * Rational(1, 1L << 62));
  EXPECT_FALSE(finest.reached);
  EXPECT_LT(finest.triangles, 100000);
  EXPECT_LE(narrow.lower, finest.upper);
  EXPECT_LE(finest.lower, narrow.upper);
}

TEST(LebesgueConstant, RefusesTolerancesAndLimitsThatAreNone) {
  const LagrangeFunctions functions = functions_of(inset_nodes(1, Rational(0)));
  EXPECT_THROW(static_cast<void>(lebesgue_constant(functions, 0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(lebesgue_constant(functions, ten_digits, 0)), ContractViolation);
}

}  // namespace
}  // namespace radcert
