// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/product_rule.h"

#include <gtest/gtest.h>

#include <utility>

#include "radcert/enclosure/gauss_legendre.h"

namespace radcert {
namespace {

/// T_2n, the first polynomial that the rule of n nodes misses.
Ball missed_polynomial(int n, const Ball& x) {
  Ball before(1);
  Ball here = x;
  for (int degree = 1; degree < 2 * n; ++degree) {
    const Ball next = 2 * x * here - before;
    before = here;
    here = next;
  }
  return here;
}

/// Its integral over [-1,1] less what the rule makes of it.
Ball missed_integral(int n) {
  const auto rule = enclosed_gauss_rule(n);
  Ball sum;
  for (std::size_t k = 0; k < rule->nodes.size(); ++k)
    sum += rule->weights[k] * missed_polynomial(n, rule->nodes[k]);
  return Ball(2) / (1 - 4 * power(Ball(n), 2)) - sum;
}

TEST(ProductRule, HoldsWhatTheRulesMissInEitherVariableAndInBoth) {
  // T_2n along x, T_2m along y, with factors of any size and of one sign, so that what both miss adds up: the
  // bound is attained.
  const BallPrecision precision(200);
  const SquareCell cell{.x_low = 0.25, .x_high = 0.75, .y_low = 0.5, .y_high = 0.625};
  for (const int n : {1, 2, 5})
    for (const int m : {1, 3, 4})
      for (const auto& [a, b] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, 1000)}) {
        const Ball in_x = missed_integral(n);
        const Ball in_y = missed_integral(m);
        const int sign = certainly_negative(in_x) == certainly_negative(in_y) ? 1 : -1;
        const Ball of_x(a);
        const Ball of_y(sign * b);
        const SquareFunction f{.in_balls =
                                   [&](const Ball& x, const Ball& y) {
                                     return of_x * missed_polynomial(n, (x - Ball(0.5)) / Ball(0.25)) +
                                            of_y * missed_polynomial(m, (y - Ball(0.5625)) / Ball(0.0625));
                                   },
                               .in_models = {}};
        const auto found = by_product_rule(f, cell, {.nodes = n, .error = abs(of_x * in_x)},
                                           {.nodes = m, .error = abs(of_y * in_y)});
        const Ball quarter_of_area = Ball(0.25) * Ball(0.0625);
        const Ball exact =
            quarter_of_area * 2 *
            (of_x * (Ball(2) / (1 - 4 * power(Ball(n), 2))) + of_y * (Ball(2) / (1 - 4 * power(Ball(m), 2))));
        EXPECT_TRUE(overlaps(found.value, exact)) << n << " " << m << " " << a << " " << b;
        const Ball off = 2 * quarter_of_area * abs(of_x * in_x + of_y * in_y);
        EXPECT_TRUE(overlaps(found.error, off)) << found.error.to_text() << " " << off.to_text();
        EXPECT_GE(found.value.radius(), off.lower_double());
        EXPECT_LE(found.value.radius(), off.upper_double() * (1 + 1e-6));
      }
}

TEST(ProductRule, MissesOnLargeEllipsesAboutAsMuchAsItsBound) {
  // |T_2n| is at most (rho^2n + rho^-2n)/2 on the ellipse.
  const BallPrecision precision(200);
  constexpr double rho = 256;
  for (const int n : {1, 2, 5, 12}) {
    const double bound = (power(Ball(rho), 2L * n) / 2 + Ball(1)).upper_double();
    const RuleInOneVariable rule = rule_for_ellipse(n, rho, bound);
    EXPECT_EQ(rule.nodes, n);
    EXPECT_TRUE(certainly_less(abs(missed_integral(n)), rule.error)) << n;
    EXPECT_TRUE(certainly_less(rule.error, Ball(2.01) * abs(missed_integral(n)))) << n;
  }
}

TEST(ProductRule, IsExactUpToTheDegreesOfItsRules) {
  const BallPrecision precision(200);
  const SquareFunction f{.in_balls = [](const Ball& x, const Ball& y) { return power(x, 5) * power(y, 3); },
                         .in_models = {}};
  const auto found = by_product_rule(f, {}, {.nodes = 3, .error = Ball(0)}, {.nodes = 2, .error = Ball(0)});
  EXPECT_TRUE(found.value.contains(Rational(1, 24)));
  EXPECT_LT(found.value.radius(), 1e-50);
}

}  // namespace
}  // namespace radcert
