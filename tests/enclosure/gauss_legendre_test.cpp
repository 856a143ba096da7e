// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(EnclosedGaussRule, IntegratesPowersUpToItsDegreeAndNoFurther) {
  const BallPrecision precision(160);
  for (const int n : {1, 2, 3, 7, 20, 41}) {
    SCOPED_TRACE(n);
    const auto rule = enclosed_gauss_rule(n);
    ASSERT_EQ(rule->nodes.size(), static_cast<std::size_t>(n));
    for (int degree = 0; degree <= 2 * n; ++degree) {
      Ball sum;
      for (std::size_t k = 0; k < rule->nodes.size(); ++k) {
        sum += rule->weights[k] * power(rule->nodes[k], degree);
      }
      const Ball exact = degree % 2 == 0 ? Ball(2) / Ball(degree + 1) : Ball(0);
      EXPECT_EQ(overlaps(sum, exact), degree < 2 * n) << degree;
      EXPECT_LT(sum.radius(), 1e-40);
    }
  }
}

TEST(EnclosedGaussRule, HasItsNodesInAscendingOrder) {
  const auto rule = enclosed_gauss_rule(12);
  for (std::size_t k = 1; k < rule->nodes.size(); ++k) {
    EXPECT_TRUE(certainly_less(rule->nodes[k - 1], rule->nodes[k]));
  }
}

TEST(EnclosedGaussRule, IsMadeForThePrecisionOfTheMoment) {
  const BallPrecision coarse(60);
  EXPECT_GT(enclosed_gauss_rule(5)->nodes[0].radius(), 1e-25);
  const BallPrecision fine(200);
  EXPECT_LT(enclosed_gauss_rule(5)->nodes[0].radius(), 1e-55);
}

/// 1/(x - a) on [-1, 1]: the error is known, and close to the bound.
Ball error_for_pole(int n, const Ball& a) {
  const auto rule = enclosed_gauss_rule(n);
  Ball sum;
  for (std::size_t k = 0; k < rule->nodes.size(); ++k) sum += rule->weights[k] / (rule->nodes[k] - a);
  return abs(log((a - 1) / (a + 1)) - sum);
}

TEST(GaussErrorFactor, BoundsTheErrorForAPoleAndIsNotFarAbove) {
  const BallPrecision precision(400);
  for (const double a : {1.05, 1.25, 2.0, 5.0}) {
    const double singular = a + std::sqrt(a * a - 1);
    for (const int n : {1, 2, 5, 12, 30}) {
      const Ball error = error_for_pole(n, Ball(a));
      Ball best = Ball(1e300);
      for (int step = 1; step < 400; ++step) {
        const double rho = 1 + (singular - 1) * step / 400;
        const Ball long_axis = (Ball(rho) + 1 / Ball(rho)) / 2;
        const Ball bound = gauss_error_factor(n, rho) / (Ball(a) - long_axis);
        EXPECT_TRUE(certainly_less(error, bound)) << "a " << a << ", n " << n << ", rho " << rho;
        best = min(best, bound);
      }
      // Largest at rho near to the pole's, where M grows with n: n against the true error, and a constant.
      const bool is_far_along = n >= 5;
      EXPECT_TRUE(!is_far_along || certainly_less(best, 60 * n * error)) << "a " << a << ", n " << n;
    }
  }
}

TEST(GaussErrorFactor, IsTheBoundForTheFirstChebyshevPolynomialLeftOut) {
  // |T_2n| is at most (rho^2n + rho^-2n)/2 on the ellipse, so as rho grows the bound falls to 2 + 2/(4n^2 -
  // 1). The error is between half of that (n = 1) and pi/4 of it (n large).
  const BallPrecision precision(200);
  for (const int n : {1, 2, 3, 8, 15}) {
    const auto rule = enclosed_gauss_rule(n);
    Ball sum;
    for (std::size_t k = 0; k < rule->nodes.size(); ++k) {
      Ball before(1);
      Ball here = rule->nodes[k];
      for (int degree = 1; degree < 2 * n; ++degree) {
        const Ball next = 2 * rule->nodes[k] * here - before;
        before = here;
        here = next;
      }
      sum += rule->weights[k] * here;
    }
    const Ball error = abs(Ball(2) / (1 - 4 * power(Ball(n), 2)) - sum);
    const Ball rho(1000);
    const Ball bound = gauss_error_factor(n, 1000) * (power(rho, 2L * n) + power(rho, -2L * n)) / 2;
    EXPECT_TRUE(certainly_less(error, bound)) << n;
    EXPECT_TRUE(certainly_less(bound, Ball(2.01) * error))
        << n << " " << error.to_text() << " " << bound.to_text();
  }
}

TEST(GaussErrorFactor, HasItsExactValues) {
  const auto near = [](const Ball& found, const Rational& exact) {
    EXPECT_TRUE(certainly_at_most(Ball(exact), found + Ball(0x1p-100)));
    EXPECT_TRUE(certainly_at_most(found, Ball(exact) + Ball(0x1p-100)));
  };
  near(gauss_error_factor(1, 2), Rational(16, 9));   // (4 + 4/3) / 4 / (1 - 1/4)
  near(gauss_error_factor(2, 2), Rational(16, 45));  // 64/15 / 16 / (3/4)
  near(gauss_error_factor(3, 1.5), Rational(1024, 1575));
}

TEST(GaussErrorFactor, RefusesAnEllipseWithoutAnInside) {
  EXPECT_THROW(static_cast<void>(gauss_error_factor(3, 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(enclosed_gauss_rule(0)), ContractViolation);
}

}  // namespace
}  // namespace radcert
