// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/algebraic_nodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/scalar/real.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Coordinates = std::array<AlgebraicExpression, 3>;

const Rational tolerance(1, 1000);

RationalPolynomial polynomial(std::vector<Rational> coefficients) {
  return RationalPolynomial(std::move(coefficients));
}

AlgebraicNumber zero_of(const RationalPolynomial& p, const Rational& lower, const Rational& upper) {
  return {p, real_zeros(p, lower, upper, 1 / power(Rational(10), 70)).at(0)};
}

AlgebraicNumber root_of(int n) { return zero_of(polynomial({-n, 0, 1}), 0, n); }

// (1 - 2a, a, a) and its permutations.
void add_orbit(std::vector<Coordinates>& nodes, const AlgebraicExpression& a) {
  const AlgebraicExpression other = Rational(1) - Rational(2) * a;
  nodes.push_back({other, a, a});
  nodes.push_back({a, other, a});
  nodes.push_back({a, a, other});
}

// Fractions beside algebraic nodes.
std::vector<Barycentric<Rational>> rounded(const AlgebraicNodes& nodes) {
  std::vector<Barycentric<Rational>> out;
  const BallPrecision scope(300);
  for (const Barycentric<Ball>& q : nodes.values()) {
    const auto near = [](const Ball& x) { return Rational::parse(x.decimal(70).midpoint).value(); };
    const Rational s = near(q.x[2]);
    const Rational t = near(q.x[1]);
    out.push_back({{1 - s - t, t, s}});
  }
  return out;
}

Outcome<BasisFacts> facts_of(const AlgebraicNodes& nodes, long most_bits = AlgebraicField::usual_bits) {
  return basis_facts(lagrange_functions(rounded(nodes)).value(), nodes, tolerance, most_bits);
}

// The six nodes of Strang and Fix: both orbits have a zero of one polynomial as coordinate.
AlgebraicNodes six_nodes(const Rational& shift = 0) {
  const RationalPolynomial p = polynomial({1, -20, 120, -240, 135});
  AlgebraicNodes nodes{.field = AlgebraicField({zero_of(p, Rational(9, 100), Rational(1, 10)),
                                                zero_of(p, Rational(44, 100), Rational(45, 100))}),
                       .nodes = {},
                       .space = monomials(2)};
  add_orbit(nodes.nodes, AlgebraicExpression::number(0) + shift);
  add_orbit(nodes.nodes, AlgebraicExpression::number(1));
  return nodes;
}

TEST(AlgebraicNumber, IsEnclosedAtAnyPrecision) {
  const AlgebraicNumber inset = zero_of(polynomial({1, -14, 15}), Rational(7, 100), Rational(8, 100));
  for (const long bits : {64L, 200L, 1000L, 20000L}) {
    const BallPrecision scope(bits);
    const Ball value = inset.value();
    EXPECT_TRUE(overlaps(value, (Ball(7) - sqrt(Ball(34))) / Ball(15)));
    EXPECT_GE(value.accurate_bits(), bits - 10);
  }
  // A zero of a square, of a polynomial with zeros close by, and beside another zero at the end of the
  // interval.
  const BallPrecision scope(400);
  const RationalPolynomial two = polynomial({-2, 0, 1});
  EXPECT_TRUE(overlaps(zero_of(two * two, 1, 2).value(), sqrt(Ball(2))));
  EXPECT_EQ(zero_of(two * two, 1, 2).degree(), 2);
  const Rational near = 1 / power(Rational(10), 60);
  const RationalPolynomial close = two * polynomial({-2 - near, 0, 1});
  const std::vector<RealZero> zeros = real_zeros(close, 1, 2, near / 1000);
  ASSERT_EQ(zeros.size(), 2U);
  EXPECT_TRUE(overlaps(AlgebraicNumber(close, zeros[0]).value(), sqrt(Ball(2))));
  EXPECT_TRUE(overlaps(AlgebraicNumber(close, zeros[1]).value(), sqrt(Ball(2 + near))));
  const RationalPolynomial with_end = two * polynomial({-1, 1});
  EXPECT_TRUE(overlaps(AlgebraicNumber(with_end, {.lower = 1, .upper = 2}).value(), sqrt(Ball(2))));
  EXPECT_THROW(AlgebraicNumber(two, {.lower = 2, .upper = 3}), ContractViolation);
  EXPECT_THROW(AlgebraicNumber(two, {.lower = -2, .upper = 2}), ContractViolation);
}

// M of the zeros of x^2 - n is n, which the bound exceeds by as little as 1/(2 n^2).
TEST(AlgebraicNumber, HasAMeasureThatItsBoundReaches) {
  for (const int n : {2, 3, 10, 1000}) {
    const Ball bound = root_of(n).log_measure();
    EXPECT_TRUE(certainly_less(log(Ball(n)), bound)) << n;
    EXPECT_TRUE(certainly_less(bound, log(Ball(n)) + Ball(Rational(1, n * n)))) << n;
  }
}

// h of the root of n is log(n)/2, and the root of 2 with a zero of a cubic polynomial make a field of degree
// 6.
TEST(AlgebraicField, BoundsHeightsTimesItsDegree) {
  const AlgebraicField field({root_of(1000), zero_of(polynomial({-1000, -1, 0, 1}), 1, 20)});
  EXPECT_TRUE(certainly_less(Ball(3) * log(Ball(1000)), field.height(0)));
  EXPECT_TRUE(certainly_less(field.height(0), Ball(Rational(301, 100)) * log(Ball(1000))));
  // All zeros of x^3 - x - 1000 are larger than 1, so that M = 1000.
  EXPECT_TRUE(certainly_less(Ball(2) * log(Ball(1000)), field.height(1)));
  EXPECT_TRUE(certainly_less(field.height(1), Ball(Rational(201, 100)) * log(Ball(1000))));
}

TEST(AlgebraicField, DecidesSigns) {
  const AlgebraicField field({root_of(2), root_of(3), root_of(6)});
  const auto two = AlgebraicExpression::number(0);
  const auto three = AlgebraicExpression::number(1);
  const auto six = AlgebraicExpression::number(2);
  EXPECT_EQ(field.sign(two * three - six).value(), 0);
  EXPECT_EQ(field.sign(six / two - three).value(), 0);
  EXPECT_EQ(field.sign((two + three) * (two + three) - Rational(5) - Rational(2) * six).value(), 0);
  EXPECT_EQ(field.sign(two * two - Rational(2)).value(), 0);
  EXPECT_EQ(field.sign(two + three - six).value(), 1);
  EXPECT_EQ(field.sign(-two).value(), -1);
  for (const int digits : {30, 100, 900}) {
    const Rational tiny = 1 / power(Rational(10), digits);
    EXPECT_EQ(field.sign(two * three - six + tiny).value(), 1);
    EXPECT_EQ(field.sign(two * three - six - tiny).value(), -1);
  }
  // A fraction that is closer to the root of 2 than its denominators let others be.
  Rational a = 1;
  Rational b = 1;
  for (int k = 0; k < 600; ++k) {
    const Rational next = a + 2 * b;
    b = a + b;
    a = next;
  }
  EXPECT_EQ(field.sign(a / b - two).value(), a * a > 2 * b * b ? 1 : -1);
  // Too few bits: no answer.
  EXPECT_FALSE(field.sign(two * three - six, 64).has_value());
  EXPECT_FALSE(field.sign(two * three - six + 1 / power(Rational(10), 100), 256).has_value());
}

// Liouville's inequality with the heights as they are bounded here.
TEST(AlgebraicField, BoundsNumbersFromBelow) {
  const AlgebraicField field({root_of(2), zero_of(polynomial({-1, -1, 0, 1}), 1, 2)});
  Draw draw(3);
  const BallPrecision scope(2000);
  const std::vector<Ball> values = field.values();
  for (int k = 0; k < 500; ++k) {
    std::vector<AlgebraicExpression> made{
        AlgebraicExpression::number(0), AlgebraicExpression::number(1),
        Rational(static_cast<long>(draw.below(9)) - 4, 1 + static_cast<long>(draw.below(5)))};
    for (int step = 0; step < 8; ++step) {
      const AlgebraicExpression a = made[draw.below(made.size())];
      const AlgebraicExpression b = made[draw.below(made.size())];
      const std::size_t kind = draw.below(4);
      if (kind == 3 && field.sign(b).value() == 0) continue;
      made.push_back(kind == 0 ? a + b : kind == 1 ? a - b : kind == 2 ? a * b : a / b);
    }
    const Ball value = abs(made.back().value(values));
    const Ball height = made.back().height(field);
    if (value.contains_zero()) {
      EXPECT_EQ(field.sign(made.back()).value(), 0);
    } else {
      EXPECT_TRUE(certainly_less(-height - Ball(Rational(1, 1000)), log(value)));
      EXPECT_TRUE(certainly_less(log(value), height + Ball(Rational(1, 1000))));
    }
  }
}

TEST(AlgebraicNodes, HaveThePrecisionOfTheExactRule) {
  const BasisFacts facts = facts_of(six_nodes()).value();
  EXPECT_EQ(facts.proof, PrecisionProof::algebraic);
  EXPECT_EQ(facts.triangle.degree, 4);
  EXPECT_EQ(facts.parallelogram.degree, 5);
  EXPECT_EQ(facts.triangle.first_failure.degree(), 5);
  EXPECT_FALSE(facts.triangle.defect.contains_zero());
  EXPECT_EQ(predicted_orders(facts).curved, 5);
  // The fractions beside them have what every six nodes have.
  EXPECT_EQ(basis_facts(lagrange_functions(rounded(six_nodes())).value(), tolerance).triangle.degree, 2);
  // So have exact nodes that are off by little.
  for (const int digits : {20, 100, 400})
    for (const int sign : {-1, 1}) {
      const BasisFacts off = facts_of(six_nodes(sign / power(Rational(10), digits))).value();
      EXPECT_EQ(off.triangle.degree, 2) << digits;
      EXPECT_EQ(off.parallelogram.degree, 3) << digits;
      EXPECT_FALSE(off.triangle.defect.contains_zero());
    }
}

TEST(AlgebraicNodes, AgreeWithTheInsetsThatGainADegree) {
  for (const int degree : {1, 3}) {
    const SuperconvergentInsets answer = superconvergent_insets(degree, Region::parallelogram);
    const SuperconvergentInset& inset = answer.insets.front();
    AlgebraicNodes nodes{.field = AlgebraicField({}), .nodes = {}, .space = monomials(degree)};
    AlgebraicExpression alpha = inset.enclosure.lower;
    if (!inset.enclosure.is_exact()) {
      nodes.field = AlgebraicField({AlgebraicNumber(answer.condition, inset.enclosure)});
      alpha = AlgebraicExpression::number(0);
    }
    for (const std::array<int, 3>& k : lattice_indices(degree)) {
      const auto x = [&](std::size_t i) {
        return alpha + (Rational(1) - Rational(3) * alpha) * Rational(k[i], degree);
      };
      nodes.nodes.push_back({x(0), x(1), x(2)});
    }
    const BasisFacts facts = facts_of(nodes).value();
    EXPECT_EQ(facts.triangle.degree, precision_at_superconvergent_inset(degree, Region::triangle).degree);
    EXPECT_EQ(facts.parallelogram.degree,
              precision_at_superconvergent_inset(degree, Region::parallelogram).degree);
  }
}

// Of rational nodes this way must say what rational arithmetic says, in spaces of one's own too.
TEST(AlgebraicNodes, AgreeWithRationalArithmeticAtRationalNodes) {
  Draw draw(9);
  int decided = 0;
  for (int k = 0; k < 40; ++k) {
    const int degree = static_cast<int>(draw.below(3));
    PlanePolynomial<Rational> bubble(3);
    bubble(1, 1) = 27, bubble(2, 1) = -27, bubble(1, 2) = -27;
    AlgebraicNodes nodes{.field = AlgebraicField({root_of(2)}), .nodes = {}, .space = monomials(degree)};
    const bool own = degree == 1 && draw.below(2) == 0;
    if (own) nodes.space.push_back(bubble);
    const long denominator = 2 + static_cast<long>(draw.below(7));
    std::vector<Barycentric<Rational>> points;
    while (points.size() < nodes.space.size()) {
      const Rational s(static_cast<long>(draw.below(static_cast<std::size_t>(denominator) + 1)), denominator);
      const Rational t(static_cast<long>(draw.below(static_cast<std::size_t>(denominator) + 1)), denominator);
      if (s + t > 1) continue;
      points.push_back({{1 - s - t, t, s}});
      nodes.nodes.push_back({1 - s - t, t, s});
    }
    PolynomialSpace space{.degree = own ? 3 : degree, .functions = {}};
    for (const PlanePolynomial<Rational>& f : nodes.space) {
      // The Bernstein coefficients of f, as the solution of interpolation at a lattice.
      const std::vector<Barycentric<Rational>> lattice = inset_nodes(space.degree, Rational(0));
      const LagrangeFunctions on_lattice = lagrange_functions(lattice).value();
      std::vector<Rational> c(lattice.size());
      for (std::size_t i = 0; i < lattice.size(); ++i)
        for (std::size_t m = 0; m < c.size(); ++m)
          c[m] +=
              f.value<Rational>(lattice[i].x[2], lattice[i].x[1]) * on_lattice.bernstein_coefficients(i)[m];
      space.functions.push_back(std::move(c));
    }
    const auto functions = lagrange_functions(space, points);
    if (!functions) continue;
    ++decided;
    const BasisFacts exact = basis_facts(*functions, tolerance);
    const BasisFacts facts = basis_facts(*functions, nodes, tolerance).value();
    EXPECT_EQ(facts.triangle.degree, exact.triangle.degree);
    EXPECT_EQ(facts.parallelogram.degree, exact.parallelogram.degree);
    EXPECT_EQ(facts.triangle.first_failure, exact.triangle.first_failure);
    EXPECT_TRUE(overlaps(facts.triangle.defect, exact.triangle.defect));
    EXPECT_EQ(facts.weights, exact.weights);
    EXPECT_EQ(product_precision(facts).triangle, product_precision(exact).triangle);
    EXPECT_EQ(product_precision(facts).parallelogram, product_precision(exact).parallelogram);
    EXPECT_LE(facts.norm.lower, exact.norm.lower);
    EXPECT_GE(facts.norm.upper, exact.norm.upper);
  }
  EXPECT_GT(decided, 15);
}

// Where too few bits are allowed there is a reason, and no wrong degree.
TEST(AlgebraicNodes, AreNotDecidedByTooFewBits) {
  for (const long bits : {2L, 16L, 64L, 200L, 512L, 1024L}) {
    const Outcome<BasisFacts> facts = facts_of(six_nodes(), bits);
    ASSERT_FALSE(facts.has_value()) << bits;
    EXPECT_THAT(facts.reason(), testing::HasSubstr("bits would be needed"));
  }
  const Outcome<BasisFacts> off = facts_of(six_nodes(1 / power(Rational(10), 400)), 1024);
  EXPECT_FALSE(off.has_value());
}

TEST(AlgebraicNodes, TellWeightsThatAreZero) {
  // Linear functions at a node a of a median, its image and a third node: its weight vanishes where 1/3 lies
  // on their line.
  AlgebraicNodes nodes{.field = AlgebraicField({root_of(2)}), .nodes = {}, .space = monomials(1)};
  const AlgebraicExpression a = AlgebraicExpression::number(0) / Rational(10);
  const AlgebraicExpression other = Rational(1) - Rational(2) * a;
  // The middle of the first two nodes is the centroid.
  nodes.nodes.push_back({other, a, a});
  nodes.nodes.push_back({Rational(2, 3) - other, Rational(2, 3) - a, Rational(2, 3) - a});
  nodes.nodes.push_back({Rational(1, 5), Rational(1, 2), Rational(3, 10)});
  const BasisFacts facts = facts_of(nodes).value();
  EXPECT_EQ(facts.weights[2], 0);
  EXPECT_GT(facts.weights[0], 0);
  EXPECT_EQ(facts.triangle.degree, 1);
}

TEST(AtTrueNodes, EnclosesNormAndConditionOfOtherNodes) {
  Draw draw(2);
  for (int k = 0; k < 60; ++k) {
    const int degree = 1 + static_cast<int>(draw.below(3));
    const std::vector<Barycentric<Rational>> near =
        inset_nodes(degree, Rational(1 + static_cast<long>(draw.below(9)), 40));
    const Rational size = 1 / power(Rational(10), 2 + static_cast<int>(draw.below(8)));
    std::vector<Barycentric<Rational>> moved = near;
    std::vector<Barycentric<Ball>> balls;
    for (Barycentric<Rational>& q : moved) {
      const Rational s = size * Rational(static_cast<long>(draw.below(2001)) - 1000, 20000);
      const Rational t = size * Rational(static_cast<long>(draw.below(2001)) - 1000, 20000);
      q = {{q.x[0] - s - t, q.x[1] + t, q.x[2] + s}};
      balls.push_back({{Ball(q.x[0]), Ball(q.x[1]), Ball(q.x[2])}});
    }
    const Rational fine(1, 100000000);
    const LagrangeFunctions functions = lagrange_functions(near).value();
    const BasisFacts facts = at_true_nodes(basis_facts(functions, fine), functions, balls).value();
    const BasisFacts truth = basis_facts(lagrange_functions(moved).value(), fine);
    EXPECT_LE(facts.norm.lower, truth.norm.upper);
    EXPECT_GE(facts.norm.upper, truth.norm.lower);
    EXPECT_GE(facts.condition, truth.condition);
    EXPECT_LE(facts.norm.upper - facts.norm.lower, 1000 * size * facts.norm.upper + 2 * fine);
  }
  // Two nodes that may be one: nothing is known.
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(1, Rational(1, 6))).value();
  std::vector<Barycentric<Ball>> wide;
  for (const Barycentric<Rational>& q : functions.nodes())
    wide.push_back(
        {{widened(Ball(q.x[0]), Ball(1)), widened(Ball(q.x[1]), Ball(1)), widened(Ball(q.x[2]), Ball(1))}});
  EXPECT_FALSE(at_true_nodes(basis_facts(functions, tolerance), functions, wide).has_value());
}

}  // namespace
}  // namespace radcert
