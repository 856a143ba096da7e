// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/kernel_integral.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert {
namespace {

const Rational half(1, 2);

void expect_value(const Enclosure& found, const Ball& exact, double radius) {
  ASSERT_TRUE(found.has_value()) << found.reason().to_text();
  EXPECT_LE(found->value.radius(), radius);
  EXPECT_TRUE(overlaps(found->value, exact)) << found->value.to_text(40) << ", " << exact.to_text(40);
}

Ball decimal(const char* text) { return *Ball::parse(text); }

/// Int G over the cube's floor or a wall from a point, by the closed forms of configuration factors times pi.
TEST(KernelIntegral, HasThirtyDigitsOfAPointAndASquare) {
  const BallPrecision precision(140);
  const Surface surface = cube();
  const ExactObserver centre_of_ceiling = ExactObserver::off_surface({half, half, 1}, {0, 0, -1});
  const auto integral = [&](std::size_t chart) {
    return kernel_integral(centre_of_ceiling, surface, chart, domain_polygon(surface.charts[chart]),
                           unit_density(), {.radius = 1e-30});
  };
  // A quarter is a rectangle of sides 1/2, 1/2 with a corner below P at distance 1: pi F = 1/2 (x atan x + x
  // atan x) with x = (1/2) / sqrt(1 + 1/4) (Howell, point to rectangle).
  const Ball x = 1 / sqrt(Ball(5));
  const Ball opposite = 4 * x * atan(x);
  expect_value(integral(4), opposite, 1e-30);
  EXPECT_TRUE(overlaps(opposite / Ball::pi(), decimal("0.239456470460773538825 +/- 1e-21")));
  // The walls share what is left of pi.
  for (const std::size_t wall : {0U, 1U, 2U, 3U})
    expect_value(integral(wall), (Ball::pi() - opposite) / 4, 1e-30);
}

/// A triangle as a part of a parallelogram.
Surface triangle_at_height_one() {
  Surface surface;
  surface.name = "triangle";
  surface.charts.push_back(make_rectangle(
      {.name = "triangle", .piece = "triangle", .orientation = Orientation::against_the_cross_product},
      {0, 0, 1}, {1, 0, 0}, {0, 1, 0}));
  return surface;
}

TEST(KernelIntegral, HasTheKnownValuesOfAPointAndATriangle) {
  const BallPrecision precision(140);
  const Surface surface = triangle_at_height_one();
  const ParameterPolygon triangle{{0, 0}, {1, 0}, {0, 1}};
  const ExactObserver upright = ExactObserver::off_surface({0, 0, 0}, {0, 0, 1});
  const ExactObserver tilted = ExactObserver::off_surface({0, 0, 0}, {1, 1, 1});
  const DensityFormula x = density([](const auto& q) { return q.point.x; });
  const Ball pi = Ball::pi();
  const auto integral = [&](const ExactObserver& p, const DensityFormula& q) {
    return kernel_integral(p, surface, 0, triangle, q, {.radius = 1e-30});
  };
  const Ball constant = 1 / (6 * sqrt(Ball(3)));
  expect_value(integral(upright, unit_density()), pi * constant, 1e-30);
  expect_value(integral(upright, x), pi * (Ball(1) / 8 - constant), 1e-30);
  expect_value(integral(tilted, unit_density()), pi * decimal("0.08878201174185088557 +/- 1e-20"), 1e-30);
  expect_value(integral(tilted, x), pi * decimal("0.02821038361001400224186293 +/- 1e-26"), 1e-30);
}

TEST(KernelIntegral, HasTheKnownValuesNearAnEdge) {
  // [ac98, (22), (23)]: from (1/3, 0, 1/7) of the upright square to the lying one, densities 1 and xi - x.
  const BallPrecision precision(140);
  const Surface surface = two_squares();
  const ExactObserver p = ExactObserver::on_surface({{0, {Rational(1, 3), Rational(1, 7)}}});
  const auto integral = [&](const DensityFormula& q) {
    return kernel_integral(p, surface, 1, domain_polygon(surface.charts[1]), q, {.radius = 1e-28});
  };
  expect_value(integral(unit_density()), decimal("1.19901694200745466734732784136 +/- 1e-29"), 1e-28);
  expect_value(integral(density([]<class R>(const DensityPoint<R>& q) { return q.at.s - R(1) / R(3); })),
               decimal("0.03587048430574663062415412568602655130141 +/- 1e-40"), 1e-28);
  expect_value(integral(density([](const auto& q) { return q.at.t; })),
               decimal("0.29708137306324786544485847876 +/- 1e-29"), 1e-28);
}

TEST(KernelIntegral, IsPiOverClosedConvexSurfaces) {
  const BallPrecision precision(112);
  const double radius = 1e-20;
  const Ball pi = Ball::pi();
  expect_value(kernel_integral(ExactObserver::on_surface({{5, {Rational(1, 3), Rational(1, 7)}}}), cube(),
                               unit_density(), {.radius = radius}),
               pi, radius);
  expect_value(kernel_integral(ExactObserver::on_surface({{0, {Rational(1, 3), Rational(1, 4)}}}), sphere(),
                               unit_density(), {.radius = radius}),
               pi, radius);
  expect_value(kernel_integral(ExactObserver::on_surface({{3, {Rational(1, 7), Rational(1, 2)}}}),
                               ellipsoid(1, 2, 5), unit_density(), {.radius = 1e-10}),
               pi, 1e-10);
}

TEST(KernelIntegral, IsPiFromPointsOfSeamsAndNearThem) {
  const BallPrecision precision(96);
  const Ball pi = Ball::pi();
  const Demand demand{.radius = 1e-7};
  // s = 0 joins the octants of either sign of y: charts 0 and 2; the pole t = 1 joins the four with z > 0.
  expect_value(
      kernel_integral(ExactObserver::on_surface({{0, {0, Rational(1, 3)}}, {2, {0, Rational(1, 3)}}}),
                      sphere(), unit_density(), demand),
      pi, 1e-7);
  expect_value(
      kernel_integral(ExactObserver::on_surface({{0, {0, 1}}, {1, {0, 1}}, {2, {0, 1}}, {3, {0, 1}}}),
                      sphere(), unit_density(), demand),
      pi, 1e-7);
  expect_value(kernel_integral(ExactObserver::on_surface({{0, {Rational(1, 1000), Rational(1, 3)}}}),
                               sphere(), unit_density(), {.radius = 1e-4}),
               pi, 1e-4);
  expect_value(kernel_integral(ExactObserver::on_surface({{1, {Rational(1, 100000), half}}}), cube(),
                               unit_density(), demand),
               pi, 1e-7);
}

TEST(KernelIntegral, IsAQuarterOfTheAreaOnTheSphere) {
  // G = 1/4; the area of a triangle with vertices a, b, c on the unit sphere by Van Oosterom and Strackee,
  // tan(A/2) = det(a,b,c) / (1 + a.b + b.c + c.a). Images of straight parameter lines are great circles.
  const BallPrecision precision(100);
  const Surface surface = sphere();
  const ParameterPolygon part{
      {Rational(1, 5), Rational(1, 10)}, {Rational(3, 5), Rational(1, 5)}, {Rational(1, 10), Rational(4, 5)}};
  std::array<Vector<Ball>, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Ball> e{Ball(1 - part[k].s - part[k].t), Ball(part[k].s), Ball(part[k].t)};
    corner[k] = (1 / norm(e)) * e;
  }
  const Ball determinant = dot(corner[0], cross(corner[1], corner[2]));
  const Ball area = 2 * atan(determinant / (1 + dot(corner[0], corner[1]) + dot(corner[1], corner[2]) +
                                            dot(corner[2], corner[0])));
  const std::vector<ParameterPoint<Rational>> places{{Rational(3, 10), Rational(3, 10)},   // inside
                                                     part[1],                              // a corner
                                                     {Rational(2, 5), Rational(3, 20)},    // on a side
                                                     {Rational(9, 10), Rational(1, 20)}};  // outside
  for (const ParameterPoint<Rational>& at : places) {
    SCOPED_TRACE(at.s.to_text() + " " + at.t.to_text());
    expect_value(kernel_integral(ExactObserver::on_surface({{0, at}}), surface, 0, part, unit_density(),
                                 {.radius = 1e-15}),
                 area / 4, 1e-15);
  }
}

TEST(KernelIntegral, AgreesWithItselfOverPartsAndFromBothSidesOfTheChart) {
  // The roof z = 2 - x^3: the sum over two parts, of which only one contains P, is the integral over the
  // whole.
  const BallPrecision precision(110);
  const Surface surface = two_piece(3);
  const ExactObserver p = ExactObserver::on_surface({{1, {Rational(2, 5), Rational(1, 3)}}});
  const DensityFormula q = density([](const auto& at) { return exp(at.point.x - at.point.y); });
  const Demand demand{.radius = 1e-16};
  const Enclosure whole = kernel_integral(p, surface, 1, domain_polygon(surface.charts[1]), q, demand);
  const Enclosure left = kernel_integral(p, surface, 1, {{0, 0}, {half, 0}, {half, 1}, {0, 1}}, q, demand);
  const Enclosure right = kernel_integral(p, surface, 1, {{half, 0}, {1, 0}, {1, 1}, {half, 1}}, q, demand);
  ASSERT_TRUE(whole && left && right);
  EXPECT_TRUE(certainly_positive(whole->value));
  EXPECT_TRUE(overlaps(whole->value, left->value + right->value))
      << whole->value.to_text() << " " << (left->value + right->value).to_text();
}

TEST(KernelIntegral, ContainsTheTruthAtEveryPrecision) {
  const Surface surface = ellipsoid(1, 1, 2);
  const ParameterPolygon part{{0, 0}, {half, 0}, {0, half}};
  const ExactObserver p = ExactObserver::on_surface({{0, {Rational(1, 4), Rational(1, 4)}}});
  const DensityFormula q =
      density([]<class R>(const DensityPoint<R>& at) { return at.point.x * at.point.z + R(1); });
  Ball truth;
  {
    const BallPrecision precision(150);
    const Enclosure found = kernel_integral(p, surface, 0, part, q, {.radius = 1e-24});
    ASSERT_TRUE(found.has_value());
    truth = found->value;
  }
  for (const long bits : {60L, 80L, 120L})
    for (const double radius : {1e-2, 1e-5, 1e-10}) {
      const BallPrecision precision(bits);
      expect_value(kernel_integral(p, surface, 0, part, q, {.radius = radius}), truth, radius);
    }
}

TEST(KernelIntegral, VanishesExactlyInAPlane) {
  const Surface surface = cube();
  const ExactObserver on_floor = ExactObserver::on_surface({{4, {half, half}}});
  const ExactObserver above_edge = ExactObserver::off_surface({2, 2, 0}, {0, 0, 1});
  for (const ExactObserver& p : {on_floor, above_edge}) {
    const Enclosure found =
        kernel_integral(p, surface, 4, domain_polygon(surface.charts[4]), unit_density(), {.radius = 1e-5});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(certainly_zero(found->value));
  }
}

TEST(KernelIntegral, TakesAPowerThatIsNotWhole) {
  // The roof z = 2 - x^(5/2) is not analytic at x = 0; from the floor below nothing else is close.
  const BallPrecision precision(80);
  const Surface surface = two_piece(Rational(5, 2));
  const ExactObserver p = ExactObserver::on_surface({{0, {Rational(1, 3), Rational(1, 3)}}});
  const Enclosure coarse =
      kernel_integral(p, surface, 1, domain_polygon(surface.charts[1]), unit_density(), {.radius = 1e-5});
  const Enclosure fine =
      kernel_integral(p, surface, 1, domain_polygon(surface.charts[1]), unit_density(), {.radius = 1e-6});
  ASSERT_TRUE(fine.has_value()) << fine.reason().to_text();
  expect_value(coarse, fine->value, 1e-5);
  // From the roof itself: the parts on both sides of x = 1/3, of which only one contains P.
  const ExactObserver above = ExactObserver::on_surface({{1, {half, half}}});
  const auto on_roof = [&](const ParameterPolygon& polygon) {
    return kernel_integral(above, surface, 1, polygon, unit_density(), {.radius = 1e-4});
  };
  const Rational cut(1, 3);
  const Enclosure whole = on_roof(domain_polygon(surface.charts[1]));
  const Enclosure near = on_roof({{cut, 0}, {1, 0}, {1, 1}, {cut, 1}});
  const Enclosure far = on_roof({{0, 0}, {cut, 0}, {cut, 1}, {0, 1}});
  ASSERT_TRUE(whole.has_value()) << whole.reason().to_text();
  ASSERT_TRUE(near && far);
  EXPECT_TRUE(overlaps(whole->value, near->value + far->value));
  const Enclosure refused = kernel_integral(ExactObserver::on_surface({{1, {0, half}}}), surface, 1,
                                            domain_polygon(surface.charts[1]), unit_density(), {.radius = 1});
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.reason().why.find("s = 0"), std::string::npos);
}

TEST(KernelIntegral, IsUndecidedWherePIsOnTheChartUnnamed) {
  const BallPrecision precision(80);
  const ExactObserver p = ExactObserver::on_surface({{0, {0, Rational(1, 3)}}});
  const Surface surface = sphere();
  const Enclosure found = kernel_integral(p, surface, 2, domain_polygon(surface.charts[2]), unit_density(),
                                          {.radius = 1e-12, .work_limit = 30000});
  ASSERT_FALSE(found.has_value());
  EXPECT_LE(found.reason().evaluations, 30000);
}

TEST(KernelIntegral, RefusesNamesThatAreNotPointsOfTheSurface) {
  const Surface surface = sphere();
  EXPECT_THROW(static_cast<void>(ExactObserver::on_surface({})), ContractViolation);
  EXPECT_THROW(static_cast<void>(ExactObserver::off_surface({0, 0, 0}, {0, 0, 0})), ContractViolation);
  EXPECT_THROW(static_cast<void>(kernel_integral(ExactObserver::on_surface({{8, {0, 0}}}), surface,
                                                 unit_density(), {.radius = 1})),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(kernel_integral(ExactObserver::on_surface({{0, {1, 1}}}), surface,
                                                 unit_density(), {.radius = 1})),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
