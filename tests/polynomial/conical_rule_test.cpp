// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/conical_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "tests/laws/rule_laws.h"

namespace radcert {
namespace {

constexpr int most_orders = 32;

double integral(const TriangleRule<double>& rule,
                const std::function<double(const Barycentric<double>&)>& f) {
  return laws::sum<double>(rule, f).value;
}

TEST(ConicalRule, HasPositiveWeightsThatSumToTheAreaAndPointsInside) {
  // Graded, a constant becomes m^15, for which 8 points in m are enough.
  for (const Grading grading : {Grading::none, Grading::apex, Grading::base})
    for (int order = 1; order <= most_orders; ++order) {
      const TriangleRule<double> rule = conical_rule<double>(order, grading);
      const int along = grading == Grading::none ? order : std::max(2 * order, 8);
      EXPECT_EQ(rule.points.size(), static_cast<std::size_t>(along * order));
      EXPECT_TRUE(laws::is_positive_in_the_open_triangle<double>(rule, 2e-15)) << order;
    }
}

TEST(ConicalRule, IntegratesPolynomialsUpToTwiceItsOrderMinusOne) {
  for (int order = 1; order <= 16; ++order)
    EXPECT_TRUE(laws::integrates_polynomials<double>(conical_rule<double>(order, Grading::none),
                                                     2 * order - 1, 2e-14))
        << order;
}

TEST(ConicalRule, MissesTheNextPowersInBothDirections) {
  // The remainders of Gauss's rules for the weights x and 1, as in the tests of gauss_rule:
  // l^(2n) is missed by (n! (n+1)!)^2 / ((2n+2) (2n+1)!^2), and l t^(2n) by n!^4 / ((2n+1) (2n)!^2) Int l^2.
  for (int n = 1; n <= 4; ++n) {
    const TriangleRule<double> rule = conical_rule<double>(n, Grading::none);
    const auto factorial = [](int m) { return std::tgamma(m + 1.0); };
    const double along = factorial(n) * factorial(n + 1) / factorial(2 * n + 1);
    const double missed_along = along * along / (2 * n + 2);
    const double l = integral(rule, [n](const auto& x) { return power(1 - x.x[0], 2 * n); });
    EXPECT_NEAR((1.0 / (2 * n + 2) - l) / missed_along, 1, 1e-6) << n;
    const double across = factorial(n) * factorial(n) / factorial(2 * n);
    const double missed_across = across * across / (2 * n + 1) / 3;
    const double lt =
        integral(rule, [n](const auto& x) { return (1 - x.x[0]) * power(x.x[2] / (1 - x.x[0]), 2 * n); });
    EXPECT_NEAR((1.0 / (2 * n + 1) / 3 - lt) / missed_across, 1, 1e-6) << n;
  }
}

TEST(ConicalRule, GatheredAtTheApexIntegratesPowersOfTheDistanceFromIt) {
  // Int l^q = 1/(q + 2), l = x_2 + x_3
  const TriangleRule<double> rule = conical_rule<double>(16, Grading::apex);
  for (const double q : {0.0, 0.25, 0.5, 1.5, 2.5, 4.0})
    EXPECT_NEAR(integral(rule, [q](const auto& x) { return std::pow(x.x[1] + x.x[2], q); }), 1 / (q + 2),
                1e-13)
        << q;
  const TriangleRule<double> plain = conical_rule<double>(16, Grading::none);
  EXPECT_GT(std::abs(integral(plain, [](const auto& x) { return std::sqrt(x.x[1] + x.x[2]); }) - 0.4), 1e-10);
}

TEST(ConicalRule, GatheredAtTheBaseIntegratesPowersOfTheDistanceFromIt) {
  // Int x_1^q = 1/((q + 1)(q + 2))
  const TriangleRule<double> rule = conical_rule<double>(16, Grading::base);
  for (const double q : {0.0, 0.25, 0.5, 1.5, 2.5, 4.0})
    EXPECT_NEAR(integral(rule, [q](const auto& x) { return std::pow(x.x[0], q); }), 1 / ((q + 1) * (q + 2)),
                1e-13)
        << q;
  const TriangleRule<double> plain = conical_rule<double>(16, Grading::none);
  EXPECT_GT(std::abs(integral(plain, [](const auto& x) { return std::sqrt(x.x[0]); }) - 4.0 / 15), 1e-7);
}

TEST(ConicalRule, GatheredStillIntegratesPolynomials) {
  // Degree d becomes degree 8 d + 15 in m: exact for 32 points while that is at most 63.
  for (const Grading grading : {Grading::apex, Grading::base})
    EXPECT_TRUE(laws::integrates_polynomials<double>(conical_rule<double>(16, grading), 6, 2e-14));
}

TEST(ConicalRule, KeepsSmallDistancesFromApexAndBaseToTheirLastDigit) {
  // m^8 of the smallest Gauss node: relative, not absolute, accuracy. 1 - l would lose it.
  const IntervalRule<double> gauss = gauss_rule<double>(64, IntervalWeight::one);
  const double least = std::pow(gauss.nodes[0], 8);
  double apex = 1;
  double base = 1;
  for (const Barycentric<double>& x : conical_rule<double>(32, Grading::apex).points)
    apex = std::min(apex, x.x[1] + x.x[2]);
  for (const Barycentric<double>& x : conical_rule<double>(32, Grading::base).points)
    base = std::min(base, x.x[0]);
  EXPECT_NEAR(apex / least, 1, 1e-14);
  EXPECT_NEAR(base / least, 1, 1e-14);
  EXPECT_LT(least, 1e-25);
}

TEST(ConicalRule, RefusesOrdersOutOfRange) {
  for (const int order : {-1, 0, 97})
    for (const Grading grading : {Grading::none, Grading::apex, Grading::base})
      EXPECT_THROW(conical_rule<double>(order, grading), ContractViolation) << order;
}

}  // namespace
}  // namespace radcert
