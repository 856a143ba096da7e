// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/lagrange_functions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/polynomial/exact_basis.h"
#include "radcert/polynomial/inset_basis.h"
#include "tests/laws/basis_laws.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

using testing::HasSubstr;

// sum_k c_k B_k(x) by de Casteljau's algorithm, which has no factorials.
Rational bernstein_sum(int degree, std::vector<Rational> c, const Barycentric<Rational>& x) {
  for (int r = degree; r > 0; --r) {
    std::vector<Rational> next;
    for (const std::array<int, 3>& k : lattice_indices(r - 1))
      next.push_back(x.x[0] * c[lattice_place({k[0] + 1, k[1], k[2]})] +
                     x.x[1] * c[lattice_place({k[0], k[1] + 1, k[2]})] +
                     x.x[2] * c[lattice_place({k[0], k[1], k[2] + 1})]);
    c = std::move(next);
  }
  return c.front();
}

TEST(LagrangeFunctions, ObeyTheLawsOfABasisAtScatteredNodes) {
  for (int degree = 0; degree <= 5; ++degree) {
    const LagrangeFunctions functions = functions_of(scattered_nodes(degree, 7));
    const Nodes points = laws::points_of_the_plane<Rational>(11, 4);
    const std::span<const Barycentric<Rational>> span(points);
    EXPECT_EQ(functions.degree(), degree);
    EXPECT_TRUE(laws::is_one_at_its_node_and_zero_at_the_others(functions, Rational(0))) << degree;
    EXPECT_TRUE(laws::is_a_partition_of_unity(functions, span, Rational(0))) << degree;
    EXPECT_TRUE(laws::reproduces_polynomials(functions, degree, span, Rational(0))) << degree;
    EXPECT_FALSE(laws::reproduces_polynomials(functions, degree + 1, span, Rational(0))) << degree;
  }
}

TEST(LagrangeFunctions, AreTheProductsOfTheInsetBasis) {
  for (const int degree : {0, 1, 2, 3, 5, 8})
    for (const Rational& inset : {Rational(0), Rational(1, 6), Rational(33, 100)}) {
      const InsetBasis<Rational> basis(degree, inset);
      const LagrangeFunctions functions = functions_of(basis.nodes());
      for (const Barycentric<Rational>& x : laws::points_of_the_plane<Rational>(12, 3)) {
        std::vector<Rational> ours(functions.size());
        std::vector<Rational> theirs(basis.size());
        functions.values(x, ours);
        basis.values(x, theirs);
        EXPECT_EQ(ours, theirs) << degree << " " << inset.to_text();
      }
    }
}

TEST(LagrangeFunctions, HaveTheBernsteinCoefficientsThatTheySay) {
  const LagrangeFunctions functions = functions_of(scattered_nodes(4, 3));
  for (const Barycentric<Rational>& x : laws::points_of_the_plane<Rational>(13)) {
    std::vector<Rational> values(functions.size());
    functions.values(x, values);
    for (std::size_t j = 0; j < functions.size(); ++j) {
      const auto c = functions.bernstein_coefficients(j);
      EXPECT_EQ(bernstein_sum(4, {c.begin(), c.end()}, x), values[j]);
    }
  }
}

TEST(LagrangeFunctions, HaveTheirDeterminant) {
  const Rational inset(1, 10);
  // Degree 1: inset J + (1 - 3 inset) I has the eigenvalues 1 and twice 1 - 3 inset.
  EXPECT_EQ(functions_of(inset_nodes(1, inset)).determinant(), Rational(49, 100));
  EXPECT_EQ(functions_of(inset_nodes(0, inset)).determinant(), 1);
  // Degree 2: a vertex has one B_k = 1, a midpoint 1/4, 1/2, 1/4.
  Nodes nodes = inset_nodes(2, Rational(0));
  EXPECT_EQ(functions_of(nodes).determinant(), Rational(1, 8));
  std::swap(nodes[0], nodes[4]);
  EXPECT_EQ(functions_of(nodes).determinant(), Rational(-1, 8));
}

TEST(LagrangeFunctions, OfTwelfthDegreeAreExact) {
  const Nodes nodes = inset_nodes(12, Rational(1, 7));
  const LagrangeFunctions functions = functions_of(nodes);
  ASSERT_EQ(functions.size(), 91U);
  for (const std::size_t j : {0U, 45U, 90U}) {
    std::vector<Rational> values(functions.size());
    functions.values(nodes[j], values);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], i == j ? 1 : 0) << i << " " << j;
  }
}

TEST(LagrangeFunctions, ExistForNodesOutsideTheTriangle) {
  const LagrangeFunctions functions = functions_of({at(-1, 3), at(2, 2), at(5, -7)});
  EXPECT_TRUE(laws::is_one_at_its_node_and_zero_at_the_others(functions, Rational(0)));
}

void expect_proof(const NotUnisolvent& reason, int degree, const Nodes& nodes) {
  ASSERT_EQ(reason.vanishing.size(), nodes.size());
  bool is_zero = true;
  for (const Rational& c : reason.vanishing) is_zero = is_zero && c == 0;
  EXPECT_FALSE(is_zero);
  for (const Barycentric<Rational>& node : nodes) EXPECT_EQ(bernstein_sum(degree, reason.vanishing, node), 0);
}

TEST(LagrangeFunctions, AreRefusedOnALine) {
  const Nodes nodes{at(0, Rational(1, 5)), at(Rational(1, 5), Rational(2, 5)),
                    at(Rational(1, 10), Rational(3, 10))};
  const Outcome<LagrangeFunctions, NotUnisolvent> outcome = lagrange_functions(nodes);
  ASSERT_FALSE(outcome.has_value());
  EXPECT_FALSE(outcome.reason().repeated.has_value());
  expect_proof(outcome.reason(), 1, nodes);
  EXPECT_THAT(outcome.reason().to_text(),
              HasSubstr("a polynomial of degree 1 other than zero vanishes at all 3"));
}

TEST(LagrangeFunctions, AreRefusedOnACircle) {
  // (3/5, 4/5) and its like lie on the unit circle, no three of them on a line.
  const Nodes nodes{at(1, 0),
                    at(0, 1),
                    at(Rational(3, 5), Rational(4, 5)),
                    at(Rational(4, 5), Rational(3, 5)),
                    at(Rational(5, 13), Rational(12, 13)),
                    at(Rational(12, 13), Rational(5, 13))};
  const Outcome<LagrangeFunctions, NotUnisolvent> outcome = lagrange_functions(nodes);
  ASSERT_FALSE(outcome.has_value());
  expect_proof(outcome.reason(), 2, nodes);
  // The conic through five of the points is the circle alone: s^2 + t^2 - 1 up to a factor.
  const auto value = [&](const Rational& s, const Rational& t) {
    return bernstein_sum(2, outcome.reason().vanishing, at(s, t));
  };
  EXPECT_NE(value(0, 0), 0);
  EXPECT_EQ(value(3, 2), value(0, 0) * -12);
  Nodes moved = nodes;
  moved[5] = at(Rational(1, 4), Rational(1, 4));
  EXPECT_TRUE(lagrange_functions(moved).has_value());
}

TEST(LagrangeFunctions, AreRefusedWhereANodeIsRepeated) {
  Nodes nodes = inset_nodes(3, Rational(1, 8));
  nodes[7] = nodes[2];
  const Outcome<LagrangeFunctions, NotUnisolvent> outcome = lagrange_functions(nodes);
  ASSERT_FALSE(outcome.has_value());
  EXPECT_EQ(outcome.reason().repeated, std::pair(std::size_t{2}, std::size_t{7}));
  EXPECT_EQ(outcome.reason().to_text(), "nodes 2 and 7 are the same point");
  expect_proof(outcome.reason(), 3, nodes);
}

TEST(LagrangeFunctions, OfLinearFunctionsWithABubbleObeyTheLawsAndNoMore) {
  const Nodes nodes = three_and_the_centroid(Rational(1, 5));
  const LagrangeFunctions functions = lagrange_functions(linear_with_bubble(), nodes).value();
  EXPECT_EQ(functions.degree(), 3);
  EXPECT_EQ(functions.reproduced_degree(), 1);
  EXPECT_EQ(functions.size(), 4U);
  EXPECT_TRUE(laws::is_a_lagrange_basis(functions, 1, Rational(0)));
  EXPECT_FALSE(laws::is_a_lagrange_basis(functions, 2, Rational(0)));
  std::vector<Rational> values(4);
  for (const Barycentric<Rational>& x : laws::points_of_the_plane<Rational>(14)) {
    functions.values(x, values);
    // Zero at the first three nodes, one at the centroid.
    const Rational b = (125 * 27 * x.x[0] * x.x[1] * x.x[2] - 81) / 44;
    EXPECT_EQ(values[3], b);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(values[i], (5 * x.x[i] - 1) / 2 - b / 3);
  }
  // The linear functions contribute 2/5 x 2/5, the bubble 1/27 of 1 - 81/125.
  EXPECT_EQ(functions.determinant(), Rational(4, 25) * Rational(44, 125) / 27);
}

TEST(LagrangeFunctions, OfASpaceOfAllPolynomialsAreTheUsualOnes) {
  for (const int degree : {0, 1, 3}) {
    PolynomialSpace space{.degree = degree, .functions = {}};
    for (std::size_t k = 0; k < polynomial_dimension(degree); ++k) {
      space.functions.emplace_back(polynomial_dimension(degree));
      space.functions.back()[k] = 1;
    }
    const Nodes nodes = scattered_nodes(degree, 5);
    const LagrangeFunctions own = lagrange_functions(space, nodes).value();
    const LagrangeFunctions usual = functions_of(nodes);
    EXPECT_EQ(own.reproduced_degree(), degree);
    EXPECT_EQ(own.determinant(), usual.determinant());
    for (std::size_t j = 0; j < usual.size(); ++j) {
      const auto one = own.bernstein_coefficients(j);
      const auto other = usual.bernstein_coefficients(j);
      EXPECT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end())) << degree << " " << j;
    }
  }
}

TEST(LagrangeFunctions, SayWhichFunctionOfASpaceVanishesAtTheNodes) {
  PolynomialSpace space = linear_with_bubble();
  // Four points of the line x_1 = 1/4.
  const Nodes on_a_line{at(Rational(1, 8), Rational(5, 8)), at(Rational(1, 4), Rational(1, 2)),
                        at(Rational(3, 8), Rational(3, 8)), at(Rational(1, 2), Rational(1, 4))};
  const auto vanishing = lagrange_functions(space, on_a_line);
  ASSERT_FALSE(vanishing.has_value());
  EXPECT_THAT(vanishing.reason().to_text(), HasSubstr("vanishes at all 4 nodes"));
  bool is_zero = true;
  for (const Rational& c : vanishing.reason().vanishing) is_zero = is_zero && c == 0;
  EXPECT_FALSE(is_zero);
  for (const Barycentric<Rational>& node : on_a_line)
    EXPECT_EQ(bernstein_sum(3, vanishing.reason().vanishing, node), 0);
  space.functions[3] = space.functions[0];
  const auto dependent = lagrange_functions(space, three_and_the_centroid(Rational(1, 5)));
  ASSERT_FALSE(dependent.has_value());
  EXPECT_THAT(dependent.reason().to_text(), HasSubstr("linearly dependent"));
  space.functions.pop_back();
  EXPECT_THROW(static_cast<void>(lagrange_functions(space, on_a_line)), ContractViolation);
}

TEST(LagrangeFunctions, KnowThatConstantsAreMissing) {
  // x_1 and x_2 alone.
  PolynomialSpace space{.degree = 1, .functions = {{1, 0, 0}, {0, 1, 0}}};
  const auto functions = lagrange_functions(space, Nodes{at(0, Rational(1, 4)), at(0, Rational(1, 2))});
  EXPECT_EQ(functions.value().reproduced_degree(), -1);
}

// A type by its formulas, and one whose functions are none of the degree that it says.
struct Bubble {
  int said_degree = 3;
  int degree() const { return said_degree; }
  std::size_t size() const { return 4; }
  Nodes nodes() const { return three_and_the_centroid(Rational(1, 5)); }
  void values(const Barycentric<Rational>& x, std::span<Rational> out) const {
    out[3] = (125 * 27 * x.x[0] * x.x[1] * x.x[2] - 81) / 44;
    for (std::size_t i = 0; i < 3; ++i) out[i] = (5 * x.x[i] - 1) / 2 - out[3] / 3;
  }
};

TEST(ExactBasis, BecomesItsLagrangeFunctions) {
  const LagrangeFunctions functions = lagrange_functions_of(Bubble{});
  const LagrangeFunctions expected =
      lagrange_functions(linear_with_bubble(), three_and_the_centroid(Rational(1, 5))).value();
  for (std::size_t j = 0; j < 4; ++j) {
    const auto one = functions.bernstein_coefficients(j);
    const auto other = expected.bernstein_coefficients(j);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end())) << j;
  }
  EXPECT_THROW(static_cast<void>(lagrange_functions_of(Bubble{2})), ContractViolation);
}

TEST(LagrangeFunctions, RefuseSetsOfAWrongSizeAndPointsThatAreNone) {
  const Nodes six = inset_nodes(2, Rational(0));
  for (const std::size_t count : {0U, 2U, 4U, 5U})
    EXPECT_THROW(static_cast<void>(lagrange_functions(std::span(six).first(count))), ContractViolation)
        << count;
  Nodes wrong = inset_nodes(1, Rational(0));
  wrong[1].x[0] = Rational(1, 100);
  EXPECT_THROW(static_cast<void>(lagrange_functions(wrong)), ContractViolation);
  const LagrangeFunctions functions = functions_of(inset_nodes(1, Rational(0)));
  std::vector<Rational> places(2);
  EXPECT_THROW(functions.values(at(0, 0), places), ContractViolation);
  EXPECT_THROW(static_cast<void>(functions.bernstein_coefficients(3)), ContractViolation);
}

}  // namespace
}  // namespace radcert
