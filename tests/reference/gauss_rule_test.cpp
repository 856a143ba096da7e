// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/cubature/gauss_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert::reference {
namespace {

/// As far as the cubature goes.
std::size_t usual(const GaussRule& rule) { return (rule.size() + 2) / 4; }

template <class Function>
GaussRule::Samples sampled(const GaussRule& rule, Function f) {
  GaussRule::Samples g{};
  for (std::size_t i = 0; i < rule.size(); ++i) g[i] = f(rule.nodes()[i]);
  return g;
}

template <class Test>
void for_each_rule(const Test& test) {
  for (std::size_t n = GaussRule::smallest; n <= GaussRule::largest; ++n) test(GaussRule::of(n));
}

TEST(GaussRule, IsExactUpToDegree2nMinus1AndNoFurther) {
  for_each_rule([](const GaussRule& rule) {
    const auto monomial_error = [&rule](std::size_t degree) {
      // (2x-1)^d has the integral 1/(d+1) for even d; the odd ones vanish by symmetry.
      const double integral = rule.integral(
          sampled(rule, [degree](double x) { return std::pow(2 * x - 1, static_cast<double>(degree)); }));
      return std::abs(integral - (degree % 2 == 0 ? 1 / static_cast<double>(degree + 1) : 0.0));
    };
    for (std::size_t degree = 0; degree < 2 * rule.size(); ++degree)
      EXPECT_LT(monomial_error(degree), 1.5e-15) << rule.size() << " points, degree " << degree;
    if (rule.size() <= 20) {  // the error is about 2^(-2n)
      EXPECT_GT(monomial_error(2 * rule.size()), 0.5 * std::pow(4, -static_cast<double>(rule.size())));
    }
  });
}

TEST(GaussRule, HasPositiveWeightsAndSymmetricIncreasingNodes) {
  for_each_rule([](const GaussRule& rule) {
    const std::size_t n = rule.size();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_GT(rule.weights()[i], 0);
      EXPECT_DOUBLE_EQ(rule.nodes()[i] + rule.nodes()[n - 1 - i], 1);
      if (i > 0) {
        EXPECT_LT(rule.nodes()[i - 1], rule.nodes()[i]);
      }
    }
    for (std::size_t i = n; i < GaussRule::largest; ++i) {
      EXPECT_EQ(rule.weights()[i], 0);
      EXPECT_EQ(rule.nodes()[i], rule.nodes()[n - 1]);
    }
  });
}

TEST(GaussRule, ErrorBoundsTheErrorAndSeesConvergence) {
  for_each_rule([](const GaussRule& rule) {
    // 1/(x + a): the pole approaches as a falls; the integral is log(1 + 1/a).
    for (double a = 4; a > 1e-4; a /= 2) {
      const GaussRule::Samples g = sampled(rule, [a](double x) { return 1 / (x + a); });
      const double truth = std::log1p(1 / a);
      const double error = std::abs(rule.integral(g) - truth);
      EXPECT_LE(error, rule.error(g, usual(rule)).value + 1e-15 * truth)
          << rule.size() << " points, a = " << a;
    }
    const GaussRule::Samples smooth = sampled(rule, [](double x) { return std::exp(x); });
    EXPECT_LT(rule.error(smooth, usual(rule)).value, rule.size() < 10 ? 1e-10 : 1e-13);
  });
}

TEST(GaussRule, ErrorBoundsTheErrorAtAKinkAndAtARoot) {
  for (const std::size_t n : {12, 16, 24, 32, 40}) {
    const GaussRule& rule = GaussRule::of(n);
    const auto bound = [&](const GaussRule::Samples& g) { return rule.error(g, usual(rule)).value; };
    for (double at = 0.1; at < 0.95; at += 0.07) {
      const GaussRule::Samples kink = sampled(rule, [at](double x) { return std::abs(x - at); });
      const double truth = 0.5 * (at * at + (1 - at) * (1 - at));
      EXPECT_LE(std::abs(rule.integral(kink) - truth), bound(kink))
          << rule.size() << " points, kink at " << at;
    }
    const GaussRule::Samples root = sampled(rule, [](double x) { return std::sqrt(x); });
    EXPECT_LE(std::abs(rule.integral(root) - 2.0 / 3), bound(root));
  }
}

TEST(GaussRule, ErrorIsNotMuchAboveThatOfHalfAPeak) {
  // 1/(x^2 + a^2) with atan(1/a)/a: found by a search for errors near what is said of them. Its peak at the
  // end is so narrow that rules see a part of it only; a narrower one fools them.
  struct Peak {
    std::size_t points;
    double width;
  };
  for (const Peak& peak : {Peak{9, 0.0763}, {14, 0.0294}, {37, 0.0356}}) {
    const GaussRule& rule = GaussRule::of(peak.points);
    const double a = peak.width;
    const GaussRule::Samples g = sampled(rule, [a](double x) { return 1 / (x * x + a * a); });
    const double error = std::abs(rule.integral(g) - std::atan(1 / a) / a);
    const double estimate = rule.error(g, usual(rule)).value;
    EXPECT_LE(error, estimate) << peak.points;
    EXPECT_GE(error, 0.4 * estimate) << peak.points;
  }
}

TEST(GaussRule, ErrorSeesASmallPartThatFallsSlowly) {
  // e^x falls at once; what is left is the pole, whose part the first coefficients hide.
  for_each_rule([](const GaussRule& rule) {
    if (rule.size() < 12) return;
    for (const double size : {1e-3, 1e-6, 1e-9})
      for (const double a : {0.3, 0.1}) {
        const GaussRule::Samples g =
            sampled(rule, [&](double x) { return std::exp(x) + size * a / (x + a); });
        const double truth = std::expm1(1.0) + size * a * std::log1p(1 / a);
        EXPECT_LE(std::abs(rule.integral(g) - truth), 3 * rule.error(g, usual(rule)).value + 1e-15)
            << rule.size() << " points, " << size << " " << a;
      }
  });
}

TEST(GaussRule, RefusesSizesThatItHasNot) {
  EXPECT_THROW(GaussRule::of(GaussRule::smallest - 1), ContractViolation);
  EXPECT_THROW(GaussRule::of(GaussRule::largest + 1), ContractViolation);
}

}  // namespace
}  // namespace radcert::reference
