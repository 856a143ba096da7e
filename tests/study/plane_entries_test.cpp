// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/plane_entries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "problems.h"
#include "radcert/collocation/certified/exchanged_corners.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/approximation.h"
#include "radcert/surface/catalogue.h"
#include "tests/collocation/certified_samples.h"

namespace radcert {
namespace {

Surface surface(const std::string& name) { return find_surface(name)->make({}); }

std::vector<PlaneChart> elements_of(const Surface& surface) {
  std::vector<PlaneChart> elements;
  for (std::size_t j = 0; j < surface.chart_count(); ++j) {
    const PlaneChart chart = plane_chart(surface, j).value();
    elements.push_back(chart.over({{{0, 0}, {1, 0}, {0, 1}}}));
    if (surface.charts[j].facts().domain == ChartDomain::unit_square)
      elements.push_back(chart.over({{{1, 0}, {1, 1}, {0, 1}}}));
  }
  return elements;
}

void expect_overlap(const CertifiedEntries& a, const CertifiedEntries& b) {
  for (std::size_t j = 0; j < a.entries.columns(); ++j)
    for (std::size_t i = 0; i < a.entries.rows(); ++i)
      ASSERT_TRUE(
          overlaps(ball_of({a.entries(i, j), a.radius(i, j)}), ball_of({b.entries(i, j), b.radius(i, j)})))
          << i << " " << j << ": " << a.entries(i, j) << " " << b.entries(i, j);
}

TEST(PlaneChart, IsTheFormulaOfTheChart) {
  for (const char* name : {"cube", "two_squares", "tetrahedron", "octahedron"}) {
    const Surface s = surface(name);
    for (std::size_t j = 0; j < s.chart_count(); ++j) {
      const PlaneChart plane = plane_chart(s, j).value();
      const Frame<Ball> frame = s.charts[j].in<Ball>().frame({Ball(Rational(1, 3)), Ball(Rational(1, 5))});
      const Vector<Rational> point = plane.point({Rational(1, 3), Rational(1, 5)});
      EXPECT_TRUE(frame.point.x.contains(point.x) && frame.point.y.contains(point.y) &&
                  frame.point.z.contains(point.z));
      const Vector<Rational> n = plane.normal();
      EXPECT_TRUE(frame.area_normal.x.contains(n.x) && frame.area_normal.y.contains(n.y) &&
                  frame.area_normal.z.contains(n.z))
          << name << " " << j;
    }
  }
  const Surface sphere = surface("sphere");
  EXPECT_FALSE(plane_chart(sphere, 0).has_value());
}

TEST(PlaneEntries, OfBothRoutesHaveCommonPoints) {
  // Nodes that are symmetric to the exchange of two corners, and nodes that are not; charts of both
  // orientations.
  const std::vector<Barycentric<Rational>> lopsided{{{Rational(1, 2), Rational(1, 3), Rational(1, 6)}},
                                                    {{Rational(1, 5), Rational(3, 5), Rational(1, 5)}},
                                                    {{Rational(1, 7), Rational(2, 7), Rational(4, 7)}}};
  for (const char* name : {"two_squares", "tetrahedron"}) {
    const std::vector<PlaneChart> elements = elements_of(surface(name));
    for (const LagrangeFunctions& functions :
         {lagrange_functions(inset_nodes(1, Rational(1, 6))).value(),
          lagrange_functions(inset_nodes(2, Rational(1, 8))).value(), lagrange_functions(lopsided).value()})
      expect_overlap(certified_plane_entries(elements, functions).value(),
                     plane_entries_in_balls(elements, functions).value());
  }
}

TEST(PlaneEntries, OfFunctionsThatAreLessSymmetricThanTheirNodesAreThoseInBalls) {
  const LagrangeFunctions functions = lopsided_functions();
  EXPECT_FALSE(places_when_exchanged(functions).has_value());
  for (const char* name : {"cube", "tetrahedron", "octahedron", "two_squares"}) {
    const std::vector<PlaneChart> elements = elements_of(surface(name));
    expect_overlap(certified_plane_entries(elements, functions).value(),
                   plane_entries_in_balls(elements, functions).value());
  }
}

TEST(PlaneEntries, InBallsHaveRowsThatContainOne) {
  // On a closed convex surface each row has the sum 1, and doubles that are rounded have not.
  const std::vector<PlaneChart> elements = elements_of(surface("tetrahedron"));
  const CertifiedEntries entries =
      plane_entries_in_balls(elements, lagrange_functions(inset_nodes(1, Rational(1, 6))).value()).value();
  for (std::size_t i = 0; i < entries.entries.rows(); ++i) {
    Rational sum = 0;
    Rational radius = 0;
    for (std::size_t j = 0; j < entries.entries.columns(); ++j) {
      sum += Rational::exactly(entries.entries(i, j));
      radius += Rational::exactly(entries.radius(i, j));
    }
    EXPECT_LE(abs(sum - Rational(1)), radius) << i;
    EXPECT_LE(radius.to_double(), 1e-15) << i;
  }
}

TEST(PlaneOperator, AppliesToTheFunctionsOfTheBasisAsTheirEntriesSay) {
  // sum_j k_ij u(v_j) = Ku(v_i) where u is a polynomial of the basis.
  const Surface s = surface("tetrahedron");
  const std::vector<PlaneChart> elements = elements_of(s);
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(2, Rational(1, 8))).value();
  const CertifiedEntries entries = certified_plane_entries(elements, functions).value();
  const Expression u = testing::expression("x^2 - 3*x*z/7 + (y - 2)/5");
  std::vector<PlanePolynomial<Rational>> density;
  std::vector<PlaneNode> nodes;
  std::vector<Ball> values;
  for (const PlaneChart& element : elements) {
    density.push_back(polynomial_on_plane(u, element.origin, element.first, element.second, 2).value());
    for (const Barycentric<Rational>& q : functions.nodes()) {
      nodes.push_back({element.point({q.x[1], q.x[2]}), element.normal()});
      values.emplace_back(density.back().value<Rational>(q.x[1], q.x[2]));
    }
  }
  const std::vector<ChartDomain> domains(elements.size(), ChartDomain::unit_triangle);
  const std::vector<Ball> ku = plane_operator(elements, domains, density, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Ball sum = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      sum += ball_of({entries.entries(i, j), entries.radius(i, j)}) * values[j];
    EXPECT_TRUE(overlaps(sum, ku[i] / Ball::pi())) << "node " << i;
    EXPECT_LT(sum.radius(), 1e-11);
    EXPECT_LT(ku[i].radius(), 1e-25);
  }
}

TEST(PolynomialOnPlane, IsTheExpression) {
  std::mt19937_64 random(5);
  const Vector<Rational> origin{1, Rational(1, 3), -2};
  const Vector<Rational> first{Rational(1, 2), 0, 3};
  const Vector<Rational> second{-1, Rational(2, 7), 0};
  for (const char* text :
       {"7/3", "x", "-x^2 + y*z", "(x + y - z)^3 / 4 - 2^(-2)", "x/(1 + 2) - (y - 1/3)^0", "(x*y)^2*z"}) {
    const Expression f = testing::expression(text);
    const auto q = polynomial_on_plane(f, origin, first, second, 8);
    ASSERT_TRUE(q.has_value()) << text;
    for (int trial = 0; trial < 10; ++trial) {
      const Rational s = Rational(static_cast<long>(random() % 100)) / 17;
      const Rational t = Rational(static_cast<long>(random() % 100)) / 13;
      const Vector<Rational> p = origin + s * first + t * second;
      const Ball value = f.evaluate<Ball>({Ball(p.x), Ball(p.y), Ball(p.z)});
      EXPECT_TRUE(value.contains(q->value<Rational>(s, t))) << text;
    }
  }
  for (const char* text : {"sqrt(x)", "1/x", "x^9", "x^(1/2)", "abs(x)", "2^x", "1/(1 - 1)", "exp(1)"})
    EXPECT_FALSE(polynomial_on_plane(testing::expression(text), origin, first, second, 8).has_value())
        << text;
}

}  // namespace
}  // namespace radcert
