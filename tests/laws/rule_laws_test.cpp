// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/laws/rule_laws.h"

namespace radcert::laws {
namespace {

TriangleRule<double> midpoints_of_sides() {
  return {.points = {{{0.5, 0.5, 0}}, {{0, 0.5, 0.5}}, {{0.5, 0, 0.5}}},
          .weights = {1.0 / 6, 1.0 / 6, 1.0 / 6}};
}

TEST(RuleLaws, KnowTheDegreeOfTheMidpointsOfTheSides) {
  EXPECT_TRUE(integrates_polynomials(midpoints_of_sides(), 2, 1e-15));
  EXPECT_FALSE(integrates_polynomials(midpoints_of_sides(), 3, 1e-3));
}

TEST(RuleLaws, RejectATriangleRuleWithPointsOnTheSidesOrBadWeights) {
  EXPECT_FALSE(is_positive_in_the_open_triangle(midpoints_of_sides(), 1e-15));
  const TriangleRule<double> centroid{.points = {{{0.25, 0.25, 0.5}}}, .weights = {0.5}};
  EXPECT_TRUE(is_positive_in_the_open_triangle(centroid, 1e-15));
  TriangleRule<double> bad = centroid;
  bad.weights[0] = 1;
  EXPECT_FALSE(is_positive_in_the_open_triangle(bad, 1e-15));
  bad.weights = {0.75, -0.25};
  EXPECT_FALSE(is_positive_in_the_open_triangle(bad, 1e-15));
  bad.points.push_back(bad.points[0]);
  EXPECT_FALSE(is_positive_in_the_open_triangle(bad, 1e-15));
  bad = centroid;
  bad.points[0].x[0] += 1e-3;
  EXPECT_FALSE(is_positive_in_the_open_triangle(bad, 1e-15));
}

TEST(RuleLaws, RejectAnIntervalRuleThatIsUnsortedClosedOrUnnormed) {
  const auto obeys = [](const IntervalRule<double>& rule) {
    return static_cast<bool>(is_positive_on_the_open_interval(rule, 1.0, 1e-15));
  };
  EXPECT_TRUE(obeys({.nodes = {0.25, 0.75}, .weights = {0.5, 0.5}}));
  EXPECT_FALSE(obeys({.nodes = {0.75, 0.25}, .weights = {0.5, 0.5}}));
  EXPECT_FALSE(obeys({.nodes = {0, 1}, .weights = {0.5, 0.5}}));
  EXPECT_FALSE(obeys({.nodes = {0.25, 1}, .weights = {0.5, 0.5}}));
  EXPECT_FALSE(obeys({.nodes = {0.25, 0.75}, .weights = {0.5, 0.25}}));
  EXPECT_FALSE(obeys({.nodes = {0.25, 0.75}, .weights = {1.5, -0.5}}));
  EXPECT_FALSE(obeys({.nodes = {0.25, 0.75}, .weights = {1}}));
}

}  // namespace
}  // namespace radcert::laws
