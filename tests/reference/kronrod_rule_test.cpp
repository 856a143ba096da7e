// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/kronrod_rule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radcert::reference {
namespace {

template <class Function>
KronrodRule::Samples sampled(const KronrodRule& rule, Function f) {
  KronrodRule::Samples g{};
  for (std::size_t i = 0; i < g.size(); ++i) g[i] = f(rule.nodes()[i]);
  return g;
}

TEST(KronrodRule, IsExactUpToDegree23AndNoFurther) {
  const KronrodRule rule;
  const auto monomial_error = [&rule](int degree) {
    // (2x-1)^d has the integral 1/(d+1) for even d; the odd ones vanish by symmetry.
    const double integral =
        rule.integral(sampled(rule, [degree](double x) { return std::pow(2 * x - 1, degree); }));
    return std::abs(integral - (degree % 2 == 0 ? 1.0 / (degree + 1) : 0.0));
  };
  for (int degree = 0; degree <= 23; ++degree)
    EXPECT_LT(monomial_error(degree), 1e-15) << "degree " << degree;
  EXPECT_GT(monomial_error(24), 1e-12);
}

TEST(KronrodRule, HasPositiveWeightsAndSymmetricIncreasingNodes) {
  const KronrodRule rule;
  for (std::size_t i = 0; i < KronrodRule::size; ++i) {
    EXPECT_GT(rule.weights()[i], 0);
    EXPECT_DOUBLE_EQ(rule.nodes()[i] + rule.nodes()[KronrodRule::size - 1 - i], 1);
    if (i > 0) {
      EXPECT_LT(rule.nodes()[i - 1], rule.nodes()[i]);
    }
  }
}

TEST(KronrodRule, ErrorBoundsTheErrorAndSeesConvergence) {
  const KronrodRule rule;
  // 1/(x + a): the pole approaches as a falls; the integral is log(1 + 1/a).
  double last = 0;
  for (double a = 4; a > 1e-4; a /= 2) {
    const KronrodRule::Samples g = sampled(rule, [a](double x) { return 1 / (x + a); });
    const double truth = std::log1p(1 / a);
    const double error = std::abs(rule.integral(g) - truth);
    EXPECT_LE(error, rule.error(g) + 4e-16 * truth) << "a = " << a;
    EXPECT_GE(rule.error(g), 0.9 * last) << "a = " << a;
    last = rule.error(g) > 1e-14 ? rule.error(g) : 0;
  }
  const KronrodRule::Samples smooth = sampled(rule, [](double x) { return std::exp(x); });
  EXPECT_LT(rule.error(smooth), 1e-15);
}

TEST(KronrodRule, ErrorBoundsTheErrorAtAKinkAndAtARoot) {
  const KronrodRule rule;
  for (double at = 0.03; at < 1; at += 0.07) {
    const KronrodRule::Samples kink = sampled(rule, [at](double x) { return std::abs(x - at); });
    const double truth = 0.5 * (at * at + (1 - at) * (1 - at));
    EXPECT_LE(std::abs(rule.integral(kink) - truth), rule.error(kink)) << "kink at " << at;
  }
  const KronrodRule::Samples root = sampled(rule, [](double x) { return std::sqrt(x); });
  EXPECT_LE(std::abs(rule.integral(root) - 2.0 / 3), rule.error(root));
}

}  // namespace
}  // namespace radcert::reference
