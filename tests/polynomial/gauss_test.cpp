// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/gauss.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball_precision.h"
#include "tests/laws/rule_laws.h"

namespace radcert {
namespace {

using Long = long double;
constexpr Long epsilon = std::numeric_limits<Long>::epsilon();
constexpr int most_points = 64;  // as far as the tests go: more are for more digits

struct Weighted {
  IntervalWeight weight;
  int power;  ///< the weight function is x^power
};
const std::vector<Weighted> both{{IntervalWeight::one, 0}, {IntervalWeight::variable, 1}};

/// Legendre's polynomial of degree m on [0,1].
Long legendre(int m, Long x) {
  const Long z = 2 * x - 1;
  Long before = 1;
  if (m == 0) return before;
  Long now = z;
  for (int k = 2; k <= m; ++k) {
    const Long next = ((2 * k - 1) * z * now - (k - 1) * before) / k;
    before = now;
    now = next;
  }
  return now;
}

TEST(GaussRule, HasAscendingNodesInsideAndPositiveWeights) {
  for (const Weighted& w : both)
    for (int n = 1; n <= most_points; ++n) {
      const IntervalRule<Long> rule = gauss_rule<Long>(n, w.weight);
      EXPECT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
      EXPECT_TRUE(laws::is_positive_on_the_open_interval<Long>(rule, 1.0L / (1 + w.power), 16 * epsilon))
          << n << " weight x^" << w.power;
    }
}

TEST(GaussRule, IntegratesPowersUpToTwiceItsPointsMinusOne) {
  // A node next to 1 that is off by epsilon moves x^k by k epsilon.
  for (const Weighted& w : both)
    for (int n = 1; n <= most_points; ++n) {
      const IntervalRule<Long> rule = gauss_rule<Long>(n, w.weight);
      for (int k = 0; k <= 2 * n - 1; ++k) {
        const Long exact = 1.0L / (k + w.power + 1);
        const Long value = laws::sum<Long>(rule, [k](const Long& x) { return power(x, k); }).value;
        EXPECT_LE(std::abs(value - exact), (16.0L + 0.5L * k) * epsilon * exact)
            << n << " points, x^" << k << ", weight x^" << w.power;
      }
    }
}

TEST(GaussRule, MissesTheNextPowerByTheNormOfItsPolynomial) {
  // Int p_n^2 w for the monic p_n that is orthogonal for x^b on [0,1]:  (n! (n+b)!)^2 / ((2n+b+1) (2n+b)!^2)
  for (const Weighted& w : both) {
    const int b = w.power;
    for (int n = 1; n <= 8; ++n) {
      const auto factorial = [](int m) { return std::tgamma(static_cast<Long>(m + 1)); };
      const Long ratio = factorial(n) * factorial(n + b) / factorial(2 * n + b);
      const Long missed = ratio * ratio / (2 * n + b + 1);
      const IntervalRule<Long> rule = gauss_rule<Long>(n, w.weight);
      const Long value = laws::sum<Long>(rule, [n](const Long& x) { return power(x, 2L * n); }).value;
      EXPECT_NEAR(static_cast<double>((1.0L / (2 * n + b + 1) - value) / missed), 1.0, 1e-7)
          << n << " points, weight x^" << b;
    }
  }
}

TEST(GaussRule, IntegratesLegendrePolynomialsUpToTwiceItsPointsMinusOneAndNotTheNext) {
  // Int P_m = 0 for m > 0;  Int x P_m = 1/2, 1/6, 0, 0, ...  Powers hardly feel the nodes near 0; these do.
  for (const Weighted& w : both)
    for (int n = 1; n <= most_points; ++n) {
      const IntervalRule<Long> rule = gauss_rule<Long>(n, w.weight);
      const auto value = [&rule](int m) {
        return laws::sum<Long>(rule, [m](const Long& x) { return legendre(m, x); }).value;
      };
      for (int m = 0; m <= 2 * n - 1; ++m) {
        Long exact = 0;
        if (m == 0) exact = 1.0L / (1 + w.power);
        if (m == 1 && w.power == 1) exact = 1.0L / 6;
        EXPECT_LE(std::abs(value(m) - exact), (16 + m) * epsilon)
            << n << " points, P_" << m << ", x^" << w.power;
      }
      EXPECT_GT(std::abs(value(2 * n)), 0.01) << n << " points, weight x^" << w.power;
    }
}

TEST(GaussRule, HasTheClosedFormsOfOneAndTwoPoints) {
  const auto expect = [](const IntervalRule<Long>& rule, const std::vector<Long>& nodes,
                         const std::vector<Long>& weights) {
    ASSERT_EQ(rule.nodes.size(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_LE(std::abs(rule.nodes[i] - nodes[i]), 2 * epsilon);
      EXPECT_LE(std::abs(rule.weights[i] - weights[i]), 2 * epsilon);
    }
  };
  const Long r3 = std::sqrt(3.0L);
  const Long r6 = std::sqrt(6.0L);
  expect(gauss_rule<Long>(1, IntervalWeight::one), {0.5L}, {1});
  expect(gauss_rule<Long>(2, IntervalWeight::one), {(3 - r3) / 6, (3 + r3) / 6}, {0.5L, 0.5L});
  expect(gauss_rule<Long>(1, IntervalWeight::variable), {2.0L / 3}, {0.5L});
  expect(gauss_rule<Long>(2, IntervalWeight::variable), {(6 - r6) / 10, (6 + r6) / 10},
         {(9 - r6) / 36, (9 + r6) / 36});
}

TEST(GaussRule, InDoubleIsTheLongDoubleOneRounded) {
  for (const Weighted& w : both)
    for (const int n : {1, 2, 3, 7, 16, 31, 64}) {
      const IntervalRule<double> rule = gauss_rule<double>(n, w.weight);
      const IntervalRule<Long> truth = gauss_rule<Long>(n, w.weight);
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        EXPECT_EQ(rule.nodes[i], static_cast<double>(truth.nodes[i]));
        EXPECT_EQ(rule.weights[i], static_cast<double>(truth.weights[i]));
      }
    }
}

// Newton's operator encloses a zero however few steps were taken to it: from a double it leaves the square of
// what that is off by.
TEST(GaussRule, EnclosesItsZerosAfterAnyNumberOfSteps) {
  const BallPrecision scope(400);
  for (const int points : {2, 3, 7, 20}) {
    const IntervalRule<Ball> sharp = gauss_rule<Ball>(points, IntervalWeight::variable);
    const std::vector<const WorkLimit*> limits = work_limits();
    const auto steps = std::ranges::find(limits, "polynomial/gauss: doublings of an enclosed zero's digits",
                                         &WorkLimit::name);
    ASSERT_NE(steps, limits.end());
    for (const long taken : {0, 1, 2}) {
      const LoweredWorkLimit lowered(**steps, taken);
      const IntervalRule<Ball> rule = gauss_rule<Ball>(points, IntervalWeight::variable);
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        EXPECT_TRUE(overlaps(rule.nodes[i], sharp.nodes[i])) << points << " " << taken;
        EXPECT_TRUE(overlaps(rule.weights[i], sharp.weights[i])) << points << " " << taken;
        EXPECT_LT(rule.nodes[i].radius(), 1e-25) << points << " " << taken;
      }
    }
  }
}

// Without a step the interval X reaches from the double twice as far as the zero is from it, and counts where
// Newton's operator has its image in X: the slope's bound, which widens with the points, decides about it.
TEST(GaussRule, HasNoZeroThatWasNotIsolated) {
  const BallPrecision scope(400);
  int failed = 0;
  int found = 0;
  for (const int points : {48, 50}) {
    const IntervalRule<Ball> sharp = gauss_rule<Ball>(points, IntervalWeight::variable);
    const IntervalRule<double> starts = gauss_rule<double>(points, IntervalWeight::variable);
    const std::vector<const WorkLimit*> limits = work_limits();
    const auto steps = std::ranges::find(limits, "polynomial/gauss: doublings of an enclosed zero's digits",
                                         &WorkLimit::name);
    ASSERT_NE(steps, limits.end());
    const LoweredWorkLimit none(**steps, 0);
    const IntervalRule<Ball> rule = gauss_rule<Ball>(points, IntervalWeight::variable);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      if (!rule.nodes[i].is_finite()) {
        ++failed;
        continue;
      }
      ++found;
      const Ball start(2 * starts.nodes[i] - 1);
      const Ball reach = Ball(2 + 0x1p-20) * abs(start - (Ball(2) * sharp.nodes[i] - Ball(1)));
      EXPECT_TRUE(certainly_at_most(abs(Ball(2) * rule.nodes[i] - Ball(1) - start), reach))
          << points << " " << i;
    }
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(found, 0);
}

TEST(GaussRule, RefusesNoPointsAndTooMany) {
  for (const int n : {-1, 0, 193}) {
    EXPECT_THROW(gauss_rule<double>(n, IntervalWeight::one), ContractViolation);
    EXPECT_THROW(gauss_rule<Long>(n, IntervalWeight::variable), ContractViolation);
  }
}

TEST(GaussRule, HasTheDigitsOfEveryArithmetic) {
  for (const IntervalWeight weight : {IntervalWeight::one, IntervalWeight::variable})
    for (const int points : {1, 2, 5, 16, 40}) {
      const IntervalRule<double> rounded = gauss_rule<double>(points, weight);
      const IntervalRule<Mpfr<50>> rule = gauss_rule<Mpfr<50>>(points, weight);
      ASSERT_EQ(rounded.nodes.size(), rule.nodes.size());
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        EXPECT_NEAR(rounded.nodes[i], rule.nodes[i].to_double(), 3e-16 * rounded.nodes[i]);
        EXPECT_NEAR(rounded.weights[i], rule.weights[i].to_double(), 1e-15 * rounded.weights[i]);
      }
      // Exact for the moments Int x^k w(x) dx up to degree 2 points - 1, in fifty digits.
      const int b = weight == IntervalWeight::variable ? 1 : 0;
      for (int k = 0; k < 2 * points; ++k) {
        Mpfr<50> moment = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
          moment += rule.weights[i] * power(rule.nodes[i], k);
        EXPECT_LT(std::abs((moment * Mpfr<50>(k + 1 + b) - Mpfr<50>(1)).to_double()), 1e-46)
            << points << " " << k;
      }
    }
}

}  // namespace
}  // namespace radcert
