// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/degree_of_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "tests/laws/rule_laws.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

TriangleRule<Rational> rule_of(const Nodes& nodes) { return interpolatory_rule(functions_of(nodes)); }

int largest(const std::array<int, 3>& k) { return std::max({k[0], k[1], k[2]}); }

struct Expected {
  int degree;
  Monomial first_failure;
  Rational defect;
};

void expect_precision(const TriangleRule<Rational>& rule, Region region, const Expected& expected) {
  const Precision found = degree_of_precision(rule, region);
  EXPECT_EQ(found.degree, expected.degree);
  EXPECT_EQ(found.first_failure, expected.first_failure) << found.first_failure.to_text();
  EXPECT_EQ(found.defect, expected.defect) << found.defect.to_text();
}

TEST(InterpolatoryRule, HasTheWeightsOfNewtonAndCotes) {
  // Fractions of the area 1/2 by multi-index class: midpoints alone at degree 2; 1/30, 3/40, 9/20 at degree
  // 3.
  const TriangleRule<Rational> two = rule_of(inset_nodes(2, Rational(0)));
  const std::vector<std::array<int, 3>> indices = lattice_indices(2);
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_EQ(two.weights[j], largest(indices[j]) == 2 ? Rational(0) : Rational(1, 6));
  const std::map<int, Rational> three{{3, Rational(1, 60)}, {2, Rational(3, 80)}, {1, Rational(9, 40)}};
  const TriangleRule<Rational> rule = rule_of(inset_nodes(3, Rational(0)));
  for (std::size_t j = 0; j < 10; ++j) EXPECT_EQ(rule.weights[j], three.at(largest(lattice_indices(3)[j])));
}

TEST(InterpolatoryRule, IsExactOfItsDegreeAtAnyNodes) {
  for (int degree = 0; degree <= 5; ++degree) {
    EXPECT_TRUE(laws::integrates_polynomials(rule_of(scattered_nodes(degree, 5)), degree, Rational(0)))
        << degree;
    EXPECT_TRUE(
        laws::integrates_polynomials(rule_of(inset_nodes(degree, Rational(1, 7))), degree, Rational(0)));
  }
}

TEST(DegreeOfPrecision, OfTheCentroidIsOne) {
  const TriangleRule<Rational> rule = rule_of(inset_nodes(0, Rational(0)));
  EXPECT_EQ(rule.weights, std::vector<Rational>{Rational(1, 2)});
  expect_precision(rule, Region::triangle, {1, {2, 0}, Rational(1, 18) - Rational(1, 12)});
  expect_precision(rule, Region::parallelogram, {1, {2, 0}, Rational(5, 18) - Rational(1, 3)});
}

TEST(DegreeOfPrecision, OfTheVerticesIsOne) {
  const TriangleRule<Rational> rule = rule_of(inset_nodes(1, Rational(0)));
  expect_precision(rule, Region::triangle, {1, {2, 0}, Rational(1, 6) - Rational(1, 12)});
  expect_precision(rule, Region::parallelogram, {1, {2, 0}, Rational(1, 2) - Rational(1, 3)});
}

TEST(DegreeOfPrecision, OfTheMidpointsIsTwoAndThreeOnAParallelogram) {
  const Rational half(1, 2);
  const TriangleRule<Rational> rule = rule_of({at(half, half), at(0, half), at(half, 0)});
  EXPECT_EQ(rule.weights, std::vector<Rational>(3, Rational(1, 6)));
  expect_precision(rule, Region::triangle, {2, {3, 0}, Rational(1, 24) - Rational(1, 20)});
  // 1/6 (4/16 + 1) - 1/5: of the six values of s, four are 1/2, one is 0 and one is 1.
  expect_precision(rule, Region::parallelogram, {3, {4, 0}, Rational(5, 24) - Rational(1, 5)});
}

TEST(DegreeOfPrecision, OfLinearInterpolationIsTwoAndThreeAtOneSixth) {
  const TriangleRule<Rational> rule = rule_of(inset_nodes(1, Rational(1, 6)));
  expect_precision(rule, Region::triangle, {2, {3, 0}, Rational(1, 1080)});
  expect_precision(rule, Region::parallelogram, {3, {4, 0}, Rational(-13, 3240)});
  for (const Rational& inset : some_insets()) {
    if (inset == Rational(1, 6)) continue;
    const TriangleRule<Rational> other = rule_of(inset_nodes(1, inset));
    EXPECT_EQ(degree_of_precision(other, Region::triangle).degree, 1) << inset.to_text();
    EXPECT_EQ(degree_of_precision(other, Region::parallelogram).degree, 1) << inset.to_text();
  }
}

TEST(DegreeOfPrecision, OfSymmetricRulesIsOddOnAParallelogram) {
  // An odd power about the centre cancels between the two triangles, so an even degree gains one; an odd one
  // gains nothing, as the part of even degree r + 1 of a polynomial that fails does not cancel.
  for (int degree = 0; degree <= 8; ++degree)
    for (const Rational& inset : some_insets()) {
      const TriangleRule<Rational> rule = rule_of(inset_nodes(degree, inset));
      const int on_triangle = degree_of_precision(rule, Region::triangle).degree;
      const int on_both = degree_of_precision(rule, Region::parallelogram).degree;
      EXPECT_GE(on_triangle, degree);
      EXPECT_EQ(on_both, on_triangle % 2 == 0 ? on_triangle + 1 : on_triangle)
          << degree << " " << inset.to_text();
    }
}

TEST(DegreeOfPrecision, OnAParallelogramNeedsBothTrianglesOfTheRule) {
  // Three nodes of no symmetry: the image under the half turn carries the same weights.
  const TriangleRule<Rational> rule = rule_of(scattered_nodes(1, 2));
  Rational sum = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const Rational& s = rule.points[j].x[2];
    const Rational& t = rule.points[j].x[1];
    sum += rule.weights[j] * (s * s * t + (1 - s) * (1 - s) * (1 - t));
  }
  EXPECT_EQ(defect(rule, Region::parallelogram, {2, 1}), sum - Rational(1, 6));
}

TEST(DegreeOfPrecision, OfRulesThatAreNotInterpolatory) {
  expect_precision({{at(0, 0)}, {Rational(1, 3)}}, Region::triangle, {-1, {0, 0}, Rational(-1, 6)});
  expect_precision({{at(0, 0)}, {Rational(1, 2)}}, Region::triangle, {0, {1, 0}, Rational(-1, 6)});
  expect_precision({{at(0, Rational(1, 3))}, {Rational(1, 2)}}, Region::triangle,
                   {0, {1, 0}, Rational(-1, 6)});
  expect_precision({{at(Rational(1, 3), 0)}, {Rational(1, 2)}}, Region::triangle,
                   {0, {0, 1}, Rational(-1, 6)});
  // The half turn makes every rule of the right weight exact for linear functions.
  EXPECT_EQ(degree_of_precision({{at(0, 0)}, {Rational(1, 2)}}, Region::parallelogram).degree, 1);
}

TEST(DegreeOfPrecision, OfTwelfthDegreeIsThatOfTheTheory) {
  const TriangleRule<Rational> rule = rule_of(inset_nodes(12, Rational(1, 10)));
  EXPECT_EQ(degree_of_precision(rule, Region::triangle).degree, 12);
  EXPECT_EQ(degree_of_precision(rule, Region::parallelogram).degree, 13);
}

TEST(DegreeOfPrecision, RefusesRulesThatAreNone) {
  EXPECT_THROW(static_cast<void>(degree_of_precision({}, Region::triangle)), ContractViolation);
  EXPECT_THROW(static_cast<void>(degree_of_precision({{at(0, 0)}, {}}, Region::triangle)), ContractViolation);
  EXPECT_THROW(static_cast<void>(defect({{at(0, 0)}, {1}}, Region::triangle, {-1, 0})), ContractViolation);
}

TEST(Monomial, NamesItself) {
  EXPECT_EQ((Monomial{0, 0}).to_text(), "1");
  EXPECT_EQ((Monomial{1, 0}).to_text(), "s");
  EXPECT_EQ((Monomial{0, 3}).to_text(), "t^3");
  EXPECT_EQ((Monomial{2, 1}).to_text(), "s^2 t");
}

}  // namespace
}  // namespace radcert
