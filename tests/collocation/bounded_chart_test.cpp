// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/bounded_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/interpolated_surface.h"

namespace radcert {
namespace {

struct Coordinate {
  const char* name;
  BoundedDouble found;
  Ball exact;
};

void append(const char* name, const Vector<BoundedDouble>& found, const Vector<Ball>& exact,
            std::vector<Coordinate>& to) {
  to.push_back({name, found.x, exact.x});
  to.push_back({name, found.y, exact.y});
  to.push_back({name, found.z, exact.z});
}

/// Parameters with and without digits beyond a double, often on the border.
Rational fraction(std::mt19937_64& random) {
  const auto of = [&](unsigned long denominator) {
    return Rational(static_cast<long>(random() % (denominator + 1)), static_cast<long>(denominator));
  };
  return random() % 3 == 0 ? of(4) : of(3UL << 40U);
}

void expect_enclosed(const Chart& chart, bool narrow, std::mt19937_64& random) {
  const BoundedChart bounded(chart);
  for (int trial = 0; trial < 40; ++trial) {
    ParameterPoint<Rational> at{fraction(random), fraction(random)};
    ParameterPoint<Rational> towards{fraction(random), fraction(random)};
    if (chart.facts().domain == ChartDomain::unit_triangle) {
      at = Rational(1, 2) * at;
      towards = Rational(1, 2) * towards;
    }
    const ParameterPoint<Rational> direction = towards - at;
    const Rational step = random() % 4 == 0 ? Rational(0) : fraction(random);
    const auto in_doubles = [](const ParameterPoint<Rational>& p) {
      return ParameterPoint<BoundedDouble>{from_rational<BoundedDouble>(p.s),
                                           from_rational<BoundedDouble>(p.t)};
    };
    const auto in_balls = [](const ParameterPoint<Rational>& p) {
      return ParameterPoint<Ball>{Ball(p.s), Ball(p.t)};
    };
    std::vector<Coordinate> coordinates;
    const Frame<BoundedDouble> frame = bounded.frame(in_doubles(at));
    const Chord<BoundedDouble> chord =
        bounded.chord_along(in_doubles(at), in_doubles(direction), from_rational<BoundedDouble>(step));
    const BallPrecision precision(200);
    const Frame<Ball> exact = chart.in<Ball>().frame(in_balls(at));
    append("point", frame.point, exact.point, coordinates);
    append("area normal", frame.area_normal, exact.area_normal, coordinates);
    append("first tangent", frame.tangent_s, exact.tangent_s, coordinates);
    append("second tangent", frame.tangent_t, exact.tangent_t, coordinates);
    const Chord<Ball> exact_chord =
        chart.in<Ball>().chord_along(in_balls(at), in_balls(direction), Ball(step));
    append("difference", chord.difference, exact_chord.difference, coordinates);
    append("bend at P", chord.bend_p, exact_chord.bend_p, coordinates);
    append("bend at Q", chord.bend_q, exact_chord.bend_q, coordinates);
    for (const Coordinate& coordinate : coordinates) {
      const std::string where = chart.facts().name + ", " + coordinate.name + " at (" + at.s.to_text() +
                                ", " + at.t.to_text() + ")";
      EXPECT_TRUE(overlaps(ball_around(coordinate.found), coordinate.exact))
          << where << ": " << coordinate.found.value() << " +- " << coordinate.found.error() << ", "
          << coordinate.exact.to_text();
      EXPECT_LT(coordinate.found.error(), narrow ? 1e-14 : 1e-9) << where;
    }
  }
}

TEST(BoundedChart, EnclosesTheChart) {
  std::mt19937_64 random(5);
  for (const Rational& p : {Rational(1), Rational(2), Rational(3)})
    for (const Chart& chart : two_piece(p).charts) expect_enclosed(chart, true, random);
  for (const Surface& surface : {ellipsoid(1, 2, 3), paraboloid_cap()})
    for (const Chart& chart : surface.charts) expect_enclosed(chart, false, random);
  const Surface exact = two_piece(3);
  for (const Chart& chart : interpolate(exact, triangulate(exact, 1), 2).surface.charts)
    expect_enclosed(chart, true, random);
}

TEST(BoundedChart, CountsWhatADoubleIsTooCoarseFor) {
  // A number that is not 0 but to which 0 is the nearest double, and one of no normal double.
  for (const int exponent : {-1100, -1075, -1060, -1022}) {
    const Ball number = Ball(3) * power(Ball(2), exponent);
    const BoundedDouble found = bounded(number);
    EXPECT_TRUE(ball_around(found).contains(number)) << exponent;
    EXPECT_GT(found.error(), 0) << exponent;
  }
  EXPECT_EQ(bounded(Ball(0)).error(), 0);
}

TEST(BoundedChart, CountsWhatItsCoefficientsAreOffBy) {
  // x = -(1 + a - e) + (1 + b + e) s: e is hardly less than half a unit of 1, by which both coefficients
  // are off when rounded, and the two terms nearly cancel, so that their sum adds hardly any bound. Of
  // the products one is looked for whose rounding adds as much.
  const Rational e = Rational::exactly(0x1.fffffp-54);
  std::mt19937_64 random(17);
  const auto little = [&] { return std::ldexp(static_cast<double>(random() % 1024), -36); };
  double closest = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Rational origin = e - Rational::exactly(1 + little());
    const Rational side = e + Rational::exactly(1 + 0x1p-24 + little());
    const Chart rectangle =
        make_rectangle({.name = "r", .piece = "r"}, {origin, 0, 0}, {side, 0, 0}, {0, 1, 0});
    const BoundedChart chart(rectangle);
    ASSERT_TRUE(chart.is_polynomial());
    const double s = 1 - little();
    const BoundedDouble found = chart.frame({BoundedDouble::exactly(s), BoundedDouble::exactly(0)}).point.x;
    const Rational off = abs(origin + Rational::exactly(s) * side - Rational::exactly(found.value()));
    EXPECT_LE(off, Rational::exactly(found.error())) << trial;
    closest = std::max(closest, (off / Rational::exactly(found.error())).to_double());
  }
  EXPECT_GT(closest, 0.6);
}

TEST(BoundedChart, ConvertsBallsBothWays) {
  const BallPrecision precision(100);
  const Ball third = Ball(1) / Ball(3);
  EXPECT_TRUE(ball_around(bounded(third)).contains(third));
  EXPECT_LT(bounded(third).error(), 1e-16);
  EXPECT_TRUE(ball_around(bounded(widened(third, Ball(1)))).contains(widened(third, Ball(1))));
  EXPECT_FALSE(ball_around(bounded(Ball(1) / Ball(0))).is_finite());
}

}  // namespace
}  // namespace radcert
