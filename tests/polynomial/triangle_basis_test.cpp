// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/triangle_basis.h"

#include <gtest/gtest.h>

#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/pack.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

// Points inside, on a side, at a vertex and outside.
std::vector<Barycentric<Rational>> some_points() {
  return {at(Rational(1, 3), Rational(1, 3)),
          at(Rational(2, 7), Rational(3, 11)),
          at(Rational(1, 2), 0),
          at(0, 1),
          at(Rational(1, 1000), Rational(1, 2)),
          at(Rational(-1, 5), Rational(7, 5))};
}

template <Field R>
Barycentric<R> rounded(const Barycentric<Rational>& x) {
  return {{from_rational<R>(x.x[0]), from_rational<R>(x.x[1]), from_rational<R>(x.x[2])}};
}

// Two formulas for the same functions: products of linear factors, and Bernstein coefficients.
TEST(TriangleBasis, OfInsetNodesIsTheInsetBasisExactly) {
  for (int degree = 0; degree <= 5; ++degree)
    for (const Rational& inset : some_insets()) {
      const InsetBasis<Rational> product(degree, inset);
      const TriangleBasis<Rational> general =
          make_triangle_basis<Rational>(functions_of(inset_nodes(degree, inset)));
      EXPECT_EQ(general.degree(), degree);
      EXPECT_EQ(general.nodes(), product.nodes());
      std::vector<Rational> one(product.size());
      std::vector<Rational> other(product.size());
      for (const Barycentric<Rational>& x : some_points()) {
        product.values(x, one);
        general.values(x, other);
        EXPECT_EQ(one, other) << degree << " " << inset.to_text();
      }
    }
}

TEST(TriangleBasis, KeepsTheBitsOfAnInsetBasis) {
  for (int degree = 0; degree <= 10; ++degree) {
    const InsetBasis<double> product(degree, 0.1);
    const TriangleBasis<double> basis(product);
    EXPECT_EQ(basis.nodes(), product.nodes());
    std::vector<double> one(product.size());
    std::vector<double> other(product.size());
    for (const Barycentric<Rational>& x : some_points()) {
      product.values(rounded<double>(x), one);
      basis.values(rounded<double>(x), other);
      EXPECT_EQ(one, other) << degree;
    }
  }
}

TEST(TriangleBasis, IsEnclosedByItsBalls) {
  for (int degree = 1; degree <= 5; ++degree) {
    const LagrangeFunctions functions = functions_of(symmetric_nodes(degree).nodes());
    const TriangleBasis<double> rounded_basis = make_triangle_basis<double>(functions);
    const TriangleBasis<Ball> enclosing = make_triangle_basis<Ball>(functions);
    std::vector<Rational> exact(functions.size());
    std::vector<double> values(functions.size());
    std::vector<Ball> balls(functions.size());
    for (const Barycentric<Rational>& x : some_points()) {
      functions.values(x, exact);
      rounded_basis.values(rounded<double>(x), values);
      enclosing.values(rounded<Ball>(x), balls);
      for (std::size_t j = 0; j < values.size(); ++j) {
        EXPECT_TRUE(balls[j].contains(exact[j])) << degree << " " << j;
        Rational largest = 1;
        for (const Rational& c : functions.bernstein_coefficients(j)) largest = std::max(largest, abs(c));
        const double units = 2 * degree + static_cast<double>(functions.size());
        // Outside the triangle the Bernstein polynomials grow: 1.6^5 is the largest sum of their absolute
        // values here.
        EXPECT_NEAR(values[j], exact[j].to_double(), 20 * units * 0x1p-53 * largest.to_double()) << degree;
      }
    }
  }
}

TEST(TriangleBasis, IsOneAtItsNodeAndZeroAtTheOthers) {
  for (int degree = 1; degree <= 4; ++degree) {
    const TriangleBasis<double> basis =
        make_triangle_basis<double>(functions_of(symmetric_nodes(degree).nodes()));
    const std::vector<Barycentric<double>> nodes = basis.nodes();
    std::vector<double> values(basis.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      basis.values(nodes[i], values);
      for (std::size_t j = 0; j < values.size(); ++j) EXPECT_NEAR(values[j], i == j ? 1 : 0, 1e-13) << degree;
    }
  }
}

TEST(TriangleBasis, GivesAPackTheBitsOfItsDoubles) {
  const TriangleBasis<double> basis = make_triangle_basis<double>(functions_of(symmetric_nodes(4).nodes()));
  const std::vector<Barycentric<Rational>> points = some_points();
  Barycentric<Pack> packed;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
      packed.x[i].set_lane(lane, points[lane % points.size()].x[i].to_double());
  std::vector<Pack> side_by_side(basis.size());
  basis.values(packed, std::span<Pack>(side_by_side));
  std::vector<double> values(basis.size());
  for (std::size_t lane = 0; lane < points.size(); ++lane) {
    basis.values(rounded<double>(points[lane]), values);
    for (std::size_t j = 0; j < values.size(); ++j) EXPECT_EQ(side_by_side[j].lane(lane), values[j]) << lane;
  }
}

TEST(TriangleBasis, RefusesWhatIsOutOfRange) {
  EXPECT_THROW(static_cast<void>(make_triangle_basis<double>(functions_of(inset_nodes(11, Rational(0))))),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
