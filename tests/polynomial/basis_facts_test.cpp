// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/basis_facts.h"

#include <gtest/gtest.h>

#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

BasisFacts facts_of(const Nodes& nodes) {
  return basis_facts(functions_of(nodes), 1 / power(Rational(10), 10));
}

TEST(BasisFacts, OfLinearInterpolation) {
  const BasisFacts facts = facts_of(inset_nodes(1, Rational(1, 6)));
  EXPECT_EQ(facts.weights, (std::vector<Rational>(3, Rational(1, 6))));
  EXPECT_EQ(facts.determinant, Rational(1, 4));
  EXPECT_EQ(facts.condition, Rational(7, 3));
  EXPECT_TRUE(facts.norm.lower <= Rational(7, 3) && Rational(7, 3) <= facts.norm.upper);
  EXPECT_EQ(facts.triangle.degree, 2);
  EXPECT_EQ(facts.triangle.first_failure, (Monomial{3, 0}));
  EXPECT_EQ(facts.parallelogram.degree, 3);
}

TEST(BasisFacts, BoundTheNormByTheCondition) {
  for (int degree = 0; degree <= 5; ++degree)
    for (const Nodes& nodes : {inset_nodes(degree, Rational(1, 10)), scattered_nodes(degree, 3)}) {
      const BasisFacts facts = facts_of(nodes);
      EXPECT_LE(facts.norm.lower, facts.condition) << degree;
      EXPECT_GE(facts.condition, Rational(1)) << degree;
      Rational sum = 0;
      for (const Rational& weight : facts.weights) sum += weight;
      EXPECT_EQ(sum, Rational(1, 2)) << degree;
    }
}

TEST(BasisFacts, KnowThePrecisionAtTheSuperconvergentInset) {
  const EnclosedPrecision one = precision_at_superconvergent_inset(1, Region::parallelogram);
  const BasisFacts facts = facts_of(inset_nodes(1, Rational(1, 6)));
  EXPECT_EQ(one.degree, facts.parallelogram.degree);
  EXPECT_EQ(one.first_failure, facts.parallelogram.first_failure);
  EXPECT_TRUE(overlaps(one.defect, facts.parallelogram.defect));
  // (7 - sqrt 34)/15 to 16 digits: the rule there misses nearly the same.
  const Rational near = Rational::exactly(0.07793654034364664);
  const TriangleRule<Rational> rule = interpolatory_rule(functions_of(inset_nodes(3, near)));
  for (const auto& [region, degree] : {std::pair(Region::triangle, 4), std::pair(Region::parallelogram, 5)}) {
    const EnclosedPrecision three = precision_at_superconvergent_inset(3, region);
    EXPECT_EQ(three.degree, degree);
    EXPECT_NEAR(three.defect.to_double(), defect(rule, region, three.first_failure).to_double(), 1e-15);
    EXPECT_GT(std::abs(three.defect.to_double()), 1e-8);
  }
  EXPECT_THROW(static_cast<void>(precision_at_superconvergent_inset(5, Region::triangle)), ContractViolation);
}

TEST(BasisFacts, OfLinearFunctionsWithABubble) {
  const BasisFacts facts =
      basis_facts(lagrange_functions(linear_with_bubble(), three_and_the_centroid(Rational(1, 5))).value(),
                  1 / power(Rational(10), 10));
  EXPECT_EQ(facts.degree, 3);
  EXPECT_EQ(facts.reproduced, 1);
  // The classical rule of degree 3: -9/16 of the area at the centroid, 25/48 at each of the others.
  EXPECT_EQ(facts.weights,
            (std::vector<Rational>{Rational(25, 96), Rational(25, 96), Rational(25, 96), Rational(-9, 32)}));
  EXPECT_EQ(facts.triangle.degree, 3);
  EXPECT_LE(facts.norm.upper - facts.norm.lower, 1 / power(Rational(10), 10));
  EXPECT_LE(facts.norm.lower, facts.condition);
  // At a corner: |l_1| + 2 |l_2| + |l_4| with B = -81/44.
  const Rational at_corner =
      Rational(2) + Rational(27, 44) + 2 * abs(Rational(-1, 2) + Rational(27, 44)) + Rational(81, 44);
  EXPECT_LE(at_corner, facts.norm.upper);
  const PredictedOrders orders = predicted_orders(facts);
  EXPECT_EQ(orders.everywhere, 2);
  EXPECT_EQ(orders.curved, 4);
  EXPECT_TRUE(orders.curved_has_logarithm);
}

TEST(PredictedOrders, AreThoseOfTheTheorems) {
  struct Case {
    int degree;
    int triangle;
    int parallelogram;
    int curved;
    bool logarithm;
    int smooth_kernel;
  };
  // Theorem 9 for r = 0, 2; odd r without and with alpha_0 (Theorem 7); the six points of degree 4; 9 at r =
  // 5.
  for (const Case& c : {Case{0, 1, 1, 2, false, 2}, Case{2, 2, 3, 4, false, 4}, Case{1, 1, 1, 2, false, 2},
                        Case{1, 2, 3, 4, true, 4}, Case{3, 4, 5, 6, true, 6}, Case{2, 4, 5, 5, false, 6},
                        Case{5, 9, 9, 8, false, 10}, Case{3, 3, 7, 5, false, 5}}) {
    const PredictedOrders orders = predicted_orders(c.degree, c.triangle, c.parallelogram);
    EXPECT_EQ(orders.everywhere, c.degree + 1);
    EXPECT_EQ(orders.at_edges, c.degree + 1);
    EXPECT_EQ(orders.curved, c.curved) << c.degree << " " << c.parallelogram;
    EXPECT_EQ(orders.curved_has_logarithm, c.logarithm) << c.degree << " " << c.parallelogram;
    EXPECT_EQ(orders.smooth_kernel, c.smooth_kernel) << c.degree << " " << c.parallelogram;
  }
}

}  // namespace
}  // namespace radcert
