// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/restricted_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/surface.h"

namespace radcert {
namespace {

using Corner = ParameterPoint<Rational>;

const std::array<Corner, 3> inside = {Corner{Rational(1, 4), Rational(1, 8)},
                                      {Rational(1, 2), Rational(1, 4)},
                                      {Rational(1, 8), Rational(5, 8)}};

template <Real R>
double size(const Vector<R>& v) {
  return nearest_double<R>(norm(v));
}

template <Real R>
void expect_the_chain_rule(const Chart& whole) {
  const Chart part = restricted_chart(whole, inside, "part");
  const auto q = [](int n, int d) { return from_rational<R>(Rational(n, d)); };
  const ParameterPoint<R> at{q(1, 4), q(1, 2)};
  const ParameterPoint<R> step{q(1, 8), q(-1, 4)};
  const auto mapped = [&](const ParameterPoint<R>& x) {
    return ParameterPoint<R>{q(1, 4) + x.s * q(1, 4) - x.t * q(1, 8),
                             q(1, 8) + x.s * q(1, 8) + x.t * q(1, 2)};
  };
  const Frame<R> frame = part.in<R>().frame(at);
  const Frame<R> expected = whole.in<R>().frame(mapped(at));
  EXPECT_LT(size<R>(frame.point - expected.point), 1e-15);
  EXPECT_LT(size<R>(frame.area_normal - q(9, 64) * expected.area_normal), 1e-15);
  EXPECT_LT(size<R>(cross(frame.tangent_s, frame.tangent_t) -
                    q(9, 64) * cross(expected.tangent_s, expected.tangent_t)),
            1e-15);
  const Chord<R> chord = part.in<R>().chord(at, step);
  EXPECT_LT(size<R>(chord.difference - (part.in<R>().frame(at + step).point - frame.point)), 1e-15);
  const Vector<R> n = frame.area_normal;
  EXPECT_LT(std::abs(nearest_double<R>(dot(chord.bend_p, n) - dot(chord.difference, n))), 1e-15);
}

TEST(RestrictedChart, FollowsTheChainRuleInEveryArithmetic) {
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5), cube()}) {
    expect_the_chain_rule<double>(surface.charts[0]);
    expect_the_chain_rule<Mpfr<50>>(surface.charts[0]);
  }
  const Chart part = restricted_chart(sphere().charts[3], inside, "part");
  const Frame<double> frame = part.in<double>().frame({0.25, 0.5});
  const Frame<Pack> packed = part.in<Pack>().frame({Pack(0.25), Pack(0.5)});
  EXPECT_EQ(packed.point.x.lane(3), frame.point.x);
  EXPECT_EQ(packed.area_normal.z.lane(7), frame.area_normal.z);
  const Frame<Ball> enclosed = part.in<Ball>().frame({Ball(Rational(1, 4)), Ball(Rational(1, 2))});
  EXPECT_LT(std::abs(enclosed.point.y.to_double() - frame.point.y), 1e-15);
}

TEST(RestrictedChart, CoversAPolygonWithAHole) {
  // The area of a side of the cube without a square hole.
  const PolygonLoop square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Rational a(1, 4);
  const Rational b(1, 2);
  const PolygonLoop hole = {{a, a}, {b, a}, {b, b}, {a, b}};
  const auto polygon = plane_polygon({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {square, hole});
  const PlaneTriangulation coarse = triangulate(polygon.value());
  const std::vector<PolygonSide> inner = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
  for (const PlaneTriangulation& domain : {coarse, graded_toward(coarse, polygon.value(), inner, 3)}) {
    const std::vector<Chart> charts = charts_over(cube().charts[0], domain);
    ASSERT_EQ(charts.size(), domain.triangles.size());
    double area = 0;
    for (const Chart& chart : charts) {
      EXPECT_EQ(chart.facts().piece, cube().charts[0].facts().piece);
      area += area_element(chart.in<double>().frame({0.25, 0.25})) / 2;
    }
    EXPECT_NEAR(area, 15.0 / 16, 1e-14);
  }
}

TEST(RestrictedChart, RefusesTrianglesOutsideTurnedOnesAndSingularCharts) {
  const Chart octant = sphere().charts[0];
  EXPECT_THROW(static_cast<void>(restricted_chart(octant, {Corner{0, 0}, {1, 0}, {1, 1}}, "part")),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(restricted_chart(octant, {inside[0], inside[2], inside[1]}, "part")),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(restricted_chart(two_piece(Rational(3, 2)).charts[1], inside, "part")),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
