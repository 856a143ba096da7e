// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/point_to_polygon.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"
#include "tests/closed_form/kernel_quadrature.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Point = Vector<Rational>;
using Polynomial = PlanePolynomial<Rational>;

Polynomial constant() {
  Polynomial one(0);
  one(0, 0) = 1;
  return one;
}

/// Degree one, a function of space: a + b.X on the polygon.
Polynomial linear(const PlanePolygon& polygon, const Rational& a, const Point& b) {
  Polynomial q(1);
  q(0, 0) = a + dot(b, polygon.origin());
  q(1, 0) = dot(b, polygon.first());
  q(0, 1) = dot(b, polygon.second());
  return q;
}

Rational decimal(const char* text) { return Rational::parse(text).value(); }

/// A fraction in [-1, 1] with a small denominator, often 0, 1 or -1.
Rational draw_fraction(Draw& draw) {
  if (draw.below(3) == 0) return Rational(static_cast<long>(draw.below(3)) - 1);
  return Rational(static_cast<long>(draw.below(33)) - 16, 16);
}

Point draw_point(Draw& draw) { return {draw_fraction(draw), draw_fraction(draw), draw_fraction(draw)}; }

/// A triangle, a quadrilateral that need not be convex, or a square with a hole, in a random plane.
PlanePolygon draw_polygon(Draw& draw) {
  for (;;) {
    std::vector<PolygonLoop> loops(1);
    const std::size_t kind = draw.below(3);
    for (std::size_t k = 0; k < (kind == 0 ? 3U : 4U); ++k) {
      loops[0].push_back({draw_fraction(draw), draw_fraction(draw)});
    }
    if (kind == 2) {
      loops[0] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      loops.push_back({{Rational(-1, 2), Rational(-1, 3)}, {Rational(1, 2), 0}, {0, Rational(3, 4)}});
    }
    const auto polygon = plane_polygon(draw_point(draw), draw_point(draw), draw_point(draw), loops);
    if (polygon) return *polygon;
  }
}

Point draw_normal(Draw& draw) {
  for (;;) {
    const Point normal = draw_point(draw);
    if (dot(normal, normal).sign() != 0) return normal;
  }
}

Polynomial draw_polynomial(Draw& draw, int degree) {
  Polynomial q(degree);
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) q(n - j, j) = draw_fraction(draw);
  }
  return q;
}

std::string shown(const Point& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

std::string shown(const PlanePolygon& polygon) {
  std::string text =
      shown(polygon.origin()) + " + s " + shown(polygon.first()) + " + t " + shown(polygon.second());
  for (const PolygonLoop& loop : polygon.loops()) {
    text += "\n ";
    for (const auto& at : loop) text += " (" + at.s.to_text() + ", " + at.t.to_text() + ")";
  }
  return text;
}

/// P above the polygon's plane or below, often above a corner or an edge's line, with a normal.
struct Eye {
  Point p;
  Point normal;
};

Eye draw_eye(Draw& draw, const PlanePolygon& polygon) {
  const PolygonLoop& loop = polygon.loops()[draw.below(polygon.loops().size())];
  const std::size_t k = draw.below(loop.size());
  ParameterPoint<Rational> foot{2 * draw_fraction(draw), 2 * draw_fraction(draw)};
  if (draw.below(3) == 0) foot = loop[k];
  if (draw.below(3) == 0)
    foot = loop[k] + (2 * draw_fraction(draw)) * (loop[(k + 1) % loop.size()] - loop[k]);
  Rational height = draw_fraction(draw);
  while (height.sign() == 0) height = draw_fraction(draw);
  return {polygon.point(foot) + height * polygon.normal(), draw_normal(draw)};
}

TEST(PointToPolygon, HasTheKnownValuesToThirtyDigits) {
  const auto triangle = plane_polygon({Point{0, 0, 1}, {0, 1, 1}, {1, 0, 1}});
  ASSERT_TRUE(triangle);
  const auto square = plane_polygon({Point{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}});
  ASSERT_TRUE(square);
  const auto side = plane_polygon({Point{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  ASSERT_TRUE(side);
  const Point origin{0, 0, 0};
  const Point up{0, 0, 1};
  const Point centre{Rational(1, 2), Rational(1, 2), 0};
  const Polynomial x = linear(*triangle, 0, {1, 0, 0});
  struct Known {
    const PlanePolygon* polygon;
    Point p;
    Point normal;
    Polynomial q;
    const char* value;  ///< with 1/pi
  };
  const std::array known{
      Known{&*triangle, origin, up, constant(), "0.096225044864937627418191463416992909274602 +/- 1e-41"},
      Known{&*triangle, origin, {1, 1, 1}, constant(), "0.08878201174185088557 +/- 1e-20"},
      Known{&*triangle, origin, up, x, "0.028774955135062372581808536583007090725397 +/- 1e-41"},
      Known{&*triangle, origin, {1, 1, 1}, x, "0.02821038361001400224186293 +/- 1e-26"},
      // 4/(pi sqrt 5) atan(1/sqrt 5)
      Known{&*square, centre, up, constant(), "0.239456470460773538825 +/- 1e-21"},
      Known{&*side, centre, up, constant(), "0.19013588238480661529 +/- 1e-20"}};
  for (const Known& one : known) {
    const auto value = point_to_polygon_within(decimal("1e-31"), one.p, one.normal, *one.polygon, one.q);
    ASSERT_TRUE(value) << value.reason();
    const BallPrecision precision(256);
    const Ball factor = *value / Ball::pi();
    EXPECT_LE(factor.radius(), 1e-30);
    EXPECT_TRUE(overlaps(factor, Ball::parse(one.value).value())) << factor.to_text(40) << " " << one.value;
  }
}

TEST(PointToPolygon, FacesOfACubeAddUpToPi) {
  // The faces of [0,1]^3, corners counterclockwise as seen from inside.
  std::vector<PlanePolygon> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int level : {0, 1}) {
      const auto at = [&](int s, int t) {
        std::array<Rational, 3> c;
        c[static_cast<std::size_t>(axis)] = level;
        c[static_cast<std::size_t>((axis + 1) % 3)] = level == 0 ? s : t;
        c[static_cast<std::size_t>((axis + 2) % 3)] = level == 0 ? t : s;
        return Point{c[0], c[1], c[2]};
      };
      faces.push_back(plane_polygon({at(0, 0), at(1, 0), at(1, 1), at(0, 1)}).value());
    }
  }
  Draw draw(1);
  const BallPrecision precision(128);
  for (int i = 0; i < 40; ++i) {
    const Point p{Rational(static_cast<long>(1 + draw.below(31)), 32),
                  Rational(static_cast<long>(1 + draw.below(31)), 32),
                  Rational(static_cast<long>(draw.below(8)), 32)};
    const Point normal = p.z.sign() == 0 ? Point{0, 0, 1} : draw_normal(draw);
    Ball sum;
    for (const PlanePolygon& face : faces) sum += point_to_polygon(p, normal, face, constant());
    EXPECT_TRUE(overlaps(sum, Ball::pi())) << shown(p) << shown(normal) << sum.to_text();
    EXPECT_LT(sum.radius(), 1e-25) << shown(p) << shown(normal);
  }
}

TEST(PointToPolygon, IsLambertsSumOfAngles) {
  // Int G dS = 1/2 sum angle_k normal_P . (r_k x r_k+1) / |r_k x r_k+1|, the vector formula; without
  // clipping.
  Draw draw(2);
  const BallPrecision precision(160);
  for (int i = 0; i < 300; ++i) {
    const PlanePolygon polygon = draw_polygon(draw);
    const Eye eye = draw_eye(draw, polygon);
    Ball sum;
    for (const PolygonLoop& loop : polygon.loops()) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point a = polygon.point(loop[k]) - eye.p;
        const Point b = polygon.point(loop[(k + 1) % loop.size()]) - eye.p;
        const Point across = cross(a, b);
        const Rational size = dot(across, across);
        const Rational along = dot(a, b);
        const Ball length = sqrt(Ball(size));
        const Ball angle = Ball::pi() / 2 - atan(Ball(along) / length);
        // The polygon lies to the left as seen from its inner side, so that the sum has the sign of the outer
        // one.
        sum -= angle / length * Ball(dot(eye.normal, across));
      }
    }
    const Ball expected = sum / 2 / sqrt(Ball(dot(eye.normal, eye.normal)));
    const Ball value = point_to_polygon(eye.p, eye.normal, polygon, constant(), BehindTangentPlane::counted);
    ASSERT_TRUE(overlaps(value, expected)) << shown(eye.p) << shown(eye.normal) << shown(polygon) << "\n"
                                           << value.to_text() << " " << expected.to_text();
    ASSERT_LT(value.radius(), 1e-30);
  }
}

TEST(PointToPolygon, AgreesWithQuadratureUpToDegreeEight) {
  Draw draw(3);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const PlanePolygon polygon = draw_polygon(draw);
    const Eye eye = draw_eye(draw, polygon);
    const int degree = static_cast<int>(draw.below(9));
    const Polynomial q = draw_polynomial(draw, degree);
    const KernelQuadrature quadrature(polygon, q);
    const KernelQuadrature::Value expected = quadrature.integral(eye.p, eye.normal);
    if (!expected.converged) continue;
    ++compared;
    for (const long bits : {128L, 256L}) {
      const BallPrecision precision(bits);
      const Ball value = point_to_polygon(eye.p, eye.normal, polygon, q, BehindTangentPlane::counted);
      ASSERT_TRUE(value.is_finite());
      ASSERT_NEAR(value.to_double(), static_cast<double>(expected.signed_part),
                  1e-13 * static_cast<double>(expected.absolute))
          << "degree " << degree << " " << shown(eye.p) << shown(eye.normal) << shown(polygon);
      ASSERT_LT(value.radius(), 1e-20);
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(PointToPolygon, CutsAtTheTangentPlane) {
  // The part in front of P and the part behind it, seen with the opposite normal, make up the whole.
  Draw draw(4);
  const BallPrecision precision(160);
  int cut = 0;
  for (int i = 0; i < 200; ++i) {
    const PlanePolygon polygon = draw_polygon(draw);
    const Eye eye = draw_eye(draw, polygon);
    const Polynomial q = draw_polynomial(draw, static_cast<int>(draw.below(4)));
    const Ball front = point_to_polygon(eye.p, eye.normal, polygon, q);
    const Ball back = point_to_polygon(eye.p, -eye.normal, polygon, q);
    const Ball whole = point_to_polygon(eye.p, eye.normal, polygon, q, BehindTangentPlane::counted);
    ASSERT_TRUE(overlaps(front - back, whole)) << shown(eye.p) << shown(eye.normal) << shown(polygon);
    ASSERT_LT(front.radius() + back.radius(), 1e-28);
    if (!certainly_zero(front) && !certainly_zero(back)) ++cut;
    // The kernel has one sign on each part.
    const Ball one = point_to_polygon(eye.p, eye.normal, polygon, constant());
    const Rational side = dot(eye.p - polygon.origin(), polygon.normal());
    EXPECT_FALSE(side.sign() > 0 ? certainly_negative(one) : certainly_positive(one)) << one.to_text();
  }
  EXPECT_GT(cut, 40);
}

TEST(PointToPolygon, CutsASquareWhereItShould) {
  // P sees the half x > 0 of [-1,1]^2 x {1}.
  const auto square = plane_polygon({Point{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}});
  const auto half = plane_polygon({Point{0, -1, 1}, {0, 1, 1}, {1, 1, 1}, {1, -1, 1}});
  const Polynomial on_square = linear(*square, 2, {3, -1, 1});
  const Polynomial on_half = linear(*half, 2, {3, -1, 1});
  const BallPrecision precision(128);
  const Ball cut = point_to_polygon({0, 0, 0}, {1, 0, 0}, *square, on_square);
  const Ball whole = point_to_polygon({0, 0, 0}, {1, 0, 0}, *half, on_half, BehindTangentPlane::counted);
  EXPECT_TRUE(overlaps(cut, whole)) << cut.to_text() << " " << whole.to_text();
  EXPECT_LT(cut.radius(), 1e-30);
}

TEST(PointToPolygon, AddsOverTheTwoSidesOfACut) {
  Draw draw(5);
  const BallPrecision precision(160);
  for (int i = 0; i < 60; ++i) {
    const Rational along(static_cast<long>(1 + draw.below(15)), 16);
    const ParameterPoint<Rational> a{0, 0};
    const ParameterPoint<Rational> b{1, draw_fraction(draw)};
    const ParameterPoint<Rational> c{draw_fraction(draw) / 2, 2};
    const ParameterPoint<Rational> m = b + along * (c - b);
    const Point origin = draw_point(draw);
    Point first = draw_point(draw);
    Point second = draw_point(draw);
    const auto whole = plane_polygon(origin, first, second, {{a, b, c}});
    if (!whole) continue;
    const auto left = plane_polygon(origin, first, second, {{a, b, m}}).value();
    const auto right = plane_polygon(origin, first, second, {{a, m, c}}).value();
    const Eye eye = draw_eye(draw, draw.below(2) == 0 ? left : *whole);
    const Polynomial q = draw_polynomial(draw, static_cast<int>(draw.below(5)));
    const Ball parts =
        point_to_polygon(eye.p, eye.normal, left, q) + point_to_polygon(eye.p, eye.normal, right, q);
    const Ball value = point_to_polygon(eye.p, eye.normal, *whole, q);
    ASSERT_TRUE(overlaps(parts, value)) << shown(eye.p) << shown(eye.normal) << shown(*whole);
    ASSERT_LT(parts.radius(), 1e-25);
  }
}

TEST(PointToPolygon, SubtractsItsHoles) {
  Draw draw(6);
  const BallPrecision precision(160);
  const PolygonLoop outer{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const PolygonLoop inner{{Rational(-1, 2), Rational(-1, 3)}, {Rational(1, 2), 0}, {0, Rational(3, 4)}};
  const Point origin{1, 2, 3};
  const Point first{1, 0, Rational(1, 2)};
  const Point second{Rational(1, 3), 2, 0};
  const PlanePolygon ring = plane_polygon(origin, first, second, {outer, inner}).value();
  const PlanePolygon whole = plane_polygon(origin, first, second, {outer}).value();
  const PlanePolygon hole = plane_polygon(origin, first, second, {inner}).value();
  for (int i = 0; i < 60; ++i) {
    const Eye eye = draw_eye(draw, ring);
    const Polynomial q = draw_polynomial(draw, static_cast<int>(draw.below(5)));
    const Ball value = point_to_polygon(eye.p, eye.normal, ring, q);
    const Ball difference =
        point_to_polygon(eye.p, eye.normal, whole, q) - point_to_polygon(eye.p, eye.normal, hole, q);
    ASSERT_TRUE(overlaps(value, difference)) << shown(eye.p) << shown(eye.normal);
    ASSERT_LT(value.radius(), 1e-25);
  }
}

TEST(PointToPolygon, IsInvariantUnderMotionsAndScaling) {
  // The rotation of the quaternion (1, 2, 3, 4), times 30; a length factor 7; a shift.
  const auto moved = [](const Point& a) {
    const Rational c(7, 30);
    return Point{c * (-20 * a.x + 4 * a.y + 22 * a.z), c * (20 * a.x - 10 * a.y + 20 * a.z),
                 c * (10 * a.x + 28 * a.y + 4 * a.z)};
  };
  const Point shift{Rational(1, 3), -2, 5};
  Draw draw(7);
  const BallPrecision precision(160);
  for (int i = 0; i < 60; ++i) {
    const PlanePolygon polygon = draw_polygon(draw);
    const Eye eye = draw_eye(draw, polygon);
    const PlanePolygon image = plane_polygon(moved(polygon.origin()) + shift, moved(polygon.first()),
                                             moved(polygon.second()), polygon.loops())
                                   .value();
    const Polynomial q = draw_polynomial(draw, static_cast<int>(draw.below(9)));
    const Ball value = point_to_polygon(eye.p, eye.normal, polygon, q);
    // dS grows by 49, G shrinks by it.
    const Ball same = point_to_polygon(moved(eye.p) + shift, moved(eye.normal), image, q);
    ASSERT_TRUE(overlaps(value, same)) << shown(eye.p) << shown(eye.normal) << shown(polygon);
    ASSERT_LT(same.radius(), 1e-20);
    // Another frame of the same plane: s = s' + 2 t', t = t'; loops and polynomial follow.
    std::vector<PolygonLoop> loops = polygon.loops();
    for (PolygonLoop& loop : loops) {
      for (auto& at : loop) at.s = at.s - 2 * at.t;
    }
    const PlanePolygon sheared =
        plane_polygon(polygon.origin(), polygon.first(), 2 * polygon.first() + polygon.second(), loops)
            .value();
    const Polynomial plain = linear(polygon, 1, {1, 2, 3});
    ASSERT_TRUE(overlaps(point_to_polygon(eye.p, eye.normal, polygon, plain),
                         point_to_polygon(eye.p, eye.normal, sheared, linear(sheared, 1, {1, 2, 3}))));
  }
}

TEST(PointToPolygon, IsLinearInThePolynomial) {
  Draw draw(8);
  const BallPrecision precision(160);
  for (int i = 0; i < 30; ++i) {
    const PlanePolygon polygon = draw_polygon(draw);
    const Eye eye = draw_eye(draw, polygon);
    const int degree = static_cast<int>(draw.below(9));
    const Polynomial q = draw_polynomial(draw, degree);
    const std::vector<Ball> moments = point_to_polygon_moments<Ball>(eye.p, eye.normal, polygon, degree);
    const std::vector<Mpfr<50>> rounded =
        point_to_polygon_moments<Mpfr<50>>(eye.p, eye.normal, polygon, degree);
    Ball sum;
    for (std::size_t k = 0; k < moments.size(); ++k) {
      sum += Ball(q.coefficients()[k]) * moments[k];
      EXPECT_LT(abs(Ball(rounded[k].to_rational()) - moments[k]).upper_double(), 1e-25);
    }
    EXPECT_TRUE(overlaps(sum, point_to_polygon(eye.p, eye.normal, polygon, q)));
  }
}

TEST(PointToPolygon, ReachesTheRadiusDemandedFarAwayAndClose) {
  const PlanePolygon triangle = plane_polygon({Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).value();
  Polynomial q(8);
  q(8, 0) = 1;
  q(3, 5) = -2;
  q(0, 0) = 1;
  for (const Point& p :
       {Point{1000000, 300000, 200000}, Point{Rational(1, 2), decimal("1e-12"), decimal("1e-12")},
        Point{2, 0, decimal("1e-15")}, Point{0, 0, decimal("1e-20")}}) {
    const auto value = point_to_polygon_within(decimal("1e-45"), p, {-1, -2, -3}, triangle, q);
    ASSERT_TRUE(value) << value.reason();
    EXPECT_LE(value->radius(), 1.0001e-45);
    const auto finer = point_to_polygon_within(decimal("1e-60"), p, {-1, -2, -3}, triangle, q);
    ASSERT_TRUE(finer);
    EXPECT_TRUE(overlaps(*value, *finer));
  }
  EXPECT_FALSE(point_to_polygon_within(decimal("1e-45"), {1, 1, 1}, {-1, -2, -3}, triangle, q,
                                       BehindTangentPlane::left_out, 64));
}

TEST(PointToPolygon, IsZeroInThePlaneAndRefusesPointsOnThePolygon) {
  const PlanePolygon square = plane_polygon({Point{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).value();
  const Polynomial q = linear(square, 1, {1, 1, 0});
  const auto value = [&](const Point& p, const Point& normal) {
    return point_to_polygon(p, normal, square, q);
  };
  EXPECT_TRUE(certainly_zero(value({2, 0, 0}, {1, 2, 3})));
  EXPECT_TRUE(certainly_zero(value({-1, 0, 0}, {1, 0, 0})));
  EXPECT_TRUE(certainly_zero(value({1, 1, 0}, {0, 0, 2})));
  EXPECT_TRUE(certainly_zero(value({Rational(1, 2), Rational(1, 2), 0}, {0, 0, 2})));
  // Behind P.
  EXPECT_TRUE(certainly_zero(value({0, 0, 1}, {0, 0, 1})));
  EXPECT_FALSE(certainly_zero(value({0, 0, 1}, {0, 0, -1})));
  EXPECT_THROW((void)value({Rational(1, 2), 0, 0}, {1, 0, 0}), ContractViolation);
  EXPECT_THROW((void)value({Rational(1, 2), Rational(1, 2), 0}, {0, 0, -1}), ContractViolation);
  EXPECT_THROW((void)value({0, 0, 0}, {0, 1, 1}), ContractViolation);
  EXPECT_THROW((void)value({0, 0, 1}, {0, 0, 0}), ContractViolation);
  EXPECT_THROW((void)point_to_polygon({0, 0, 1}, {0, 0, -1}, square, Polynomial(9)), ContractViolation);
  EXPECT_THROW((void)point_to_polygon_within(0, {0, 0, 1}, {0, 0, -1}, square, q), ContractViolation);
}

}  // namespace
}  // namespace radcert
