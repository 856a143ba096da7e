// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/free_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/search/free_search.h"

namespace radcert {
namespace {

const Rational radius = 1 / power(Rational(10), 59);

FreeSearchResult cubic(std::size_t threads) {
  const ThreadLimit limit(threads);
  return search_free_nodes(free_goal(3), {.starts = 32, .steps = 8},
                           [](const FreeSearchResult&) { return true; });
}

double factorial_of(int n) { return std::tgamma(n + 1.0); }

TEST(FreeNodes, AreFoundForDegree3WhereSymmetricOnesAreNot) {
  const FreeSearchResult found = cubic(1);
  ASSERT_TRUE(found.best);
  const Outcome<SymmetricCertificate> proof = certify(found.best->nodes, radius);
  ASSERT_TRUE(proof) << proof.reason();
  EXPECT_EQ(proof->triangle.degree, 4);
  EXPECT_EQ(proof->parallelogram.degree, 7);
  // The integrals of the monomials, in double.
  const TriangleRule<Ball>& rule = proof->rule;
  for (int i = 0; i <= 7; ++i)
    for (int j = 0; i + j <= 7; ++j) {
      double on_triangle = 0;
      double on_square = 0;
      for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const double w = rule.weights[k].to_double();
        const double s = rule.points[k].x[2].to_double();
        const double t = rule.points[k].x[1].to_double();
        on_triangle += w * std::pow(s, i) * std::pow(t, j);
        on_square += w * (std::pow(s, i) * std::pow(t, j) + std::pow(1 - s, i) * std::pow(1 - t, j));
      }
      EXPECT_NEAR(on_square, 1.0 / ((i + 1) * (j + 1)), 1e-14) << i << " " << j;
      if (i + j > 4) continue;
      EXPECT_NEAR(on_triangle, factorial_of(i) * factorial_of(j) / factorial_of(i + j + 2), 1e-14)
          << i << " " << j;
    }
  const FreeSearchResult again = cubic(3);
  ASSERT_TRUE(again.best);
  EXPECT_EQ(again.best->norm, found.best->norm);
  EXPECT_EQ(again.best->nodes.nodes[4].s, found.best->nodes.nodes[4].s);

  // What is moved, or is short of a number, proves nothing.
  FreeNodes moved = found.best->nodes;
  moved.nodes[0].s += Rational(1, 1000);
  EXPECT_FALSE(certify(moved, radius));
  FreeNodes held = found.best->nodes;
  for (FreeNode& node : held.nodes) node.holds_s = true;
  EXPECT_FALSE(certify(held, radius));
  EXPECT_FALSE(sharpened(held));
  FreeNodes fewer = found.best->nodes;
  fewer.nodes.pop_back();
  EXPECT_FALSE(certify(fewer, radius));
  EXPECT_THROW(static_cast<void>(certify(moved, 0)), ContractViolation);
}

// Of an even degree the equations on the parallelogram make the rule exact of one degree more on the triangle
// than the order asks for.
TEST(FreeNodes, AreFoundForDegree2) {
  const FreeSearchResult found = search_free_nodes(free_goal(2), {.starts = 16, .steps = 0},
                                                   [](const FreeSearchResult&) { return true; });
  ASSERT_TRUE(found.best);
  const Outcome<SymmetricCertificate> proof = certify(found.best->nodes, radius);
  ASSERT_TRUE(proof) << proof.reason();
  EXPECT_EQ(proof->triangle.degree, 4);
  EXPECT_EQ(proof->parallelogram.degree, 5);
}

// An odd degree asks for no equation, so that nothing of the next even one would be proved.
TEST(FreeNodes, AreCertifiedForEvenDegreesOnTheParallelogram) {
  FreeNodes three{.degree = 1, .triangle = 2, .parallelogram = 2, .nodes = {}};
  const Rational sixth(1, 6);
  const Rational most(2, 3);
  three.nodes = {{.s = sixth, .t = sixth, .weight = sixth, .holds_s = true, .holds_t = true},
                 {.s = sixth, .t = most, .weight = sixth, .holds_s = true},
                 {.s = most, .t = sixth, .weight = sixth}};
  const Outcome<SymmetricCertificate> proof = certify(three, radius);
  ASSERT_TRUE(proof) << proof.reason();
  EXPECT_EQ(proof->triangle.degree, 2);
  EXPECT_EQ(proof->parallelogram.degree, 3);
  three.parallelogram = 3;
  EXPECT_THROW(static_cast<void>(certify(three, radius)), ContractViolation);
}

TEST(FreeNodes, CountTheirEquations) {
  EXPECT_EQ(free_equations(4, 6), 15 + 7);
  EXPECT_EQ(free_equations(2, 4), 6 + 5);
  EXPECT_EQ(free_equations(3, 4), 10 + 5);
  EXPECT_EQ(free_equations(5, 4), 21);
  EXPECT_TRUE(hindrance(free_goal(1)));  // 9 numbers, 11 equations
  for (const int degree : {2, 3, 4}) EXPECT_FALSE(hindrance(free_goal(degree))) << degree;
}

}  // namespace
}  // namespace radcert
