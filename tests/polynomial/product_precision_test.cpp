// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/product_precision.h"

#include <gtest/gtest.h>

#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/algebraic_nodes.h"
#include "radcert/polynomial/nodes/search/free_search.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/scalar/real.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

const Rational tolerance(1, 1000);

// The largest d by its definition: Int q (p - P p) for every pair of monomials s^i t^j, summed over a rule of
// degree 8 with equidistant nodes, on sigma and on its image under the half turn with its own interpolation.
// What is below `zero` counts as 0.
int by_definition(const LagrangeFunctions& functions, Region region, const Rational& zero) {
  const TriangleRule<Rational> rule = interpolatory_rule(functions_of(inset_nodes(8, Rational(0))));
  std::vector<std::vector<Rational>> l(rule.points.size(), std::vector<Rational>(functions.size()));
  for (std::size_t i = 0; i < l.size(); ++i) functions.values(rule.points[i], l[i]);
  const auto over_one = [&](const Monomial& q, const Monomial& p, bool turned) {
    const auto value = [turned](const Monomial& m, const Barycentric<Rational>& x) {
      const Rational s = turned ? 1 - x.x[2] : x.x[2];
      const Rational t = turned ? 1 - x.x[1] : x.x[1];
      return power(s, m.s) * power(t, m.t);
    };
    std::vector<Rational> at_nodes;
    for (const Barycentric<Rational>& node : functions.nodes()) at_nodes.push_back(value(p, node));
    Rational sum = 0;
    for (std::size_t i = 0; i < l.size(); ++i) {
      Rational rest = value(p, rule.points[i]);
      for (std::size_t j = 0; j < at_nodes.size(); ++j) rest -= at_nodes[j] * l[i][j];
      sum += rule.weights[i] * value(q, rule.points[i]) * rest;
    }
    return sum;
  };
  for (int total = 0; total <= 8; ++total)
    for (int of_p = functions.reproduced_degree() + 1; of_p <= total; ++of_p)
      for (int a = 0; a <= total - of_p; ++a)
        for (int b = 0; b <= of_p; ++b) {
          const Monomial q{total - of_p - a, a};
          const Monomial p{of_p - b, b};
          Rational rest = over_one(q, p, false);
          if (region == Region::parallelogram) rest += over_one(q, p, true);
          if (abs(rest) > zero) return total - 1;
        }
  return 8;
}

// Six nodes of degree 2 whose rule with its image under the half turn is exact of degree 5 on the
// parallelogram, and of degree 2 alone on the triangle. In u = 2s - 1, v = 2t - 1 they are the middle of the
// side x_1 = 0, (-a, 0), (0, -a), (-b, -b), (b, -b), (-b, b): with weights of means w, 4/(45 a^4), half of
// 1/(18 b^4) at each of the last two, the means of u^2, u^4, u^2 v^2 are 1/3, 1/5, 1/9 on the square, and
// that of u on the triangle is -1/3, where A = 1/a and B = 1/b have 4 A^2 + 5 B^2 = 15, 8 A^3 + 5 B^3 = 30.
AlgebraicNodes six_nodes_for_parallelograms() {
  const RationalPolynomial p(std::vector<Rational>{-33, 0, 45, -4, -15, 0, 2});
  AlgebraicNodes nodes{
      .field = AlgebraicField(
          {{p, real_zeros(p, Rational(6, 5), Rational(5, 4), 1 / power(Rational(10), 70)).at(0)}}),
      .nodes = {},
      .space = monomials(2)};
  const AlgebraicExpression one = AlgebraicExpression::number(0) / AlgebraicExpression::number(0);
  const AlgebraicExpression of_b = AlgebraicExpression::number(0);
  const AlgebraicExpression of_a =
      (Rational(6) - of_b * of_b * of_b) / (Rational(2) * (Rational(3) - of_b * of_b));
  const AlgebraicExpression a = one / of_a;
  const AlgebraicExpression b = one / of_b;
  const AlgebraicExpression none = one - one;
  const auto add = [&](const AlgebraicExpression& u, const AlgebraicExpression& v) {
    nodes.nodes.push_back({none - (u + v) / Rational(2), (one + v) / Rational(2), (one + u) / Rational(2)});
  };
  add(none, none);
  add(none - a, none);
  add(none, none - a);
  add(none - b, none - b);
  add(b, none - b);
  add(none - b, b);
  return nodes;
}

std::vector<Barycentric<Rational>> rounded(const AlgebraicNodes& nodes) {
  std::vector<Barycentric<Rational>> out;
  const BallPrecision scope(300);
  for (const Barycentric<Ball>& q : nodes.values()) {
    const auto near = [](const Ball& x) { return Rational::parse(x.decimal(70).midpoint).value(); };
    out.push_back(at(near(q.x[2]), near(q.x[1])));
  }
  return out;
}

TEST(ProductPrecision, IsThatOfTheDefinition) {
  std::vector<LagrangeFunctions> all;
  for (int degree = 0; degree <= 3; ++degree) {
    all.push_back(functions_of(inset_nodes(degree, Rational(1, 6))));
    all.push_back(functions_of(inset_nodes(degree, Rational(1, 10))));
    if (degree > 2) continue;
    all.push_back(functions_of(scattered_nodes(degree, 4)));
  }
  all.push_back(
      functions_of({at(Rational(1, 2), Rational(1, 2)), at(Rational(1, 2), 0), at(0, Rational(1, 2))}));
  all.push_back(functions_of({at(Rational(1, 2), Rational(1, 2))}));
  all.push_back(lagrange_functions(linear_with_bubble(), three_and_the_centroid(Rational(1, 5))).value());
  for (const LagrangeFunctions& functions : all) {
    const BasisFacts facts = basis_facts(functions, tolerance);
    const ProductPrecision products = product_precision(facts);
    for (const auto& [region, said] : {std::pair(Region::triangle, products.triangle),
                                       std::pair(Region::parallelogram, products.parallelogram)}) {
      EXPECT_EQ(said, by_definition(functions, region, 0)) << functions.size() << " nodes";
      EXPECT_EQ(said, product_precision(functions, region)) << functions.size() << " nodes";
    }
    // The first part of products_follow.
    EXPECT_EQ(facts.parallelogram.degree % 2, 1);
    EXPECT_TRUE(facts.triangle.degree % 2 == 0 || facts.parallelogram.degree == facts.triangle.degree);
  }
}

TEST(ProductPrecision, OfTheBubbleIsThree) {
  const LagrangeFunctions functions =
      lagrange_functions(linear_with_bubble(), three_and_the_centroid(Rational(1, 5))).value();
  for (const Region region : {Region::triangle, Region::parallelogram})
    EXPECT_EQ(product_precision(functions, region), 3);
}

// Of a rule that is exact of three degrees more on the parallelogram than on the triangle, P p is another
// polynomial on either triangle, and q P p is not integrated.
TEST(ProductPrecision, OfAlgebraicNodesIsNotThatOfTheirRuleOnTheParallelogram) {
  const AlgebraicNodes nodes = six_nodes_for_parallelograms();
  const LagrangeFunctions near = lagrange_functions(rounded(nodes)).value();
  const BasisFacts facts = basis_facts(near, nodes, tolerance).value();
  EXPECT_EQ(facts.triangle.degree, 2);
  EXPECT_EQ(facts.parallelogram.degree, 5);
  const Rational zero = 1 / power(Rational(10), 50);
  EXPECT_EQ(product_precision(facts).triangle, by_definition(near, Region::triangle, zero));
  EXPECT_EQ(product_precision(facts).triangle, 2);
  EXPECT_EQ(product_precision(facts).parallelogram, by_definition(near, Region::parallelogram, zero));
  EXPECT_EQ(product_precision(facts).parallelogram, 3);
  EXPECT_EQ(predicted_orders(facts).smooth_kernel, 4);
}

TEST(ProductPrecision, OfCertifiedNodesIsNotThatOfTheirRuleOnTheParallelogram) {
  const FreeSearchResult found =
      search_free_nodes({.degree = 3, .triangle = 4, .parallelogram = 6}, {.starts = 8, .steps = 0},
                        [](const FreeSearchResult&) { return true; });
  ASSERT_TRUE(found.best);
  const SymmetricCertificate proof = certify(found.best->nodes, 1 / power(Rational(10), 59)).value();
  const LagrangeFunctions near = functions_of(found.best->nodes.points());
  const BasisFacts facts = certified_facts(basis_facts(near, tolerance), near, proof).value();
  EXPECT_EQ(facts.triangle.degree, 4);
  EXPECT_EQ(facts.parallelogram.degree, 7);
  const Rational zero = 1 / power(Rational(10), 50);
  EXPECT_EQ(product_precision(facts).triangle, by_definition(near, Region::triangle, zero));
  EXPECT_EQ(product_precision(facts).parallelogram, by_definition(near, Region::parallelogram, zero));
  EXPECT_EQ(product_precision(facts).parallelogram, 5);
  const PredictedOrders orders = predicted_orders(facts);
  EXPECT_EQ(orders.curved, 6);
  EXPECT_TRUE(orders.curved_has_logarithm);

  // Products of the degrees that are exact are not said to be missed, whatever the balls.
  const Rational change = 1 / power(Rational(10), 50);
  const BallPrecision scope(512);
  for (const int total : {0, 2, 4})
    EXPECT_FALSE(products_certainly_missed(near, proof.rule.points, change, total));
  EXPECT_TRUE(products_certainly_missed(near, proof.rule.points, change, 6));
  EXPECT_FALSE(products_certainly_missed(near, proof.rule.points, Rational(9, 10), 6));

  // Without them the degrees of the rule do not say what the products have.
  BasisFacts without = facts;
  without.products.reset();
  EXPECT_THROW(static_cast<void>(product_precision(without)), ContractViolation);
}

}  // namespace
}  // namespace radcert
