// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/polygon_integral.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/enclosure/ellipse_bound.h"

namespace radcert {
namespace {

const ParameterPolygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const ParameterPolygon triangle{{0, 0}, {1, 0}, {0, 1}};

void expect_value(const Enclosure& found, const Ball& exact, double radius) {
  ASSERT_TRUE(found.has_value()) << found.reason().to_text();
  EXPECT_LE(found->value.radius(), radius);
  EXPECT_TRUE(overlaps(found->value, exact)) << found->value.to_text(40) << ", " << exact.to_text(40);
}

TEST(IntegralOverPolygon, IntegratesMonomialsOverTriangleAndSquare) {
  const BallPrecision precision(160);
  const Demand demand{.radius = 1e-32};
  for (const int i : {0, 1, 3})
    for (const int j : {0, 2, 5}) {
      SCOPED_TRACE(::testing::Message() << i << " " << j);
      const auto f = [i, j](const auto& at) { return power(at.s, i) * power(at.t, j); };
      expect_value(integral_over_polygon(f, square, demand), 1 / (Ball(i + 1) * Ball(j + 1)), 1e-32);
      // i! j! / (i + j + 2)!
      Ball exact = 1;
      for (int k = 2; k <= i; ++k) exact *= k;
      for (int k = 2; k <= j; ++k) exact *= k;
      for (int k = 2; k <= i + j + 2; ++k) exact /= k;
      expect_value(integral_over_polygon(f, triangle, demand), exact, 1e-32);
    }
}

TEST(IntegralOverPolygon, DoesNotDependOnTheOrderOfTheCorners) {
  const BallPrecision precision(128);
  const Demand demand{.radius = 1e-22};
  const auto f = [](const auto& at) { return exp(at.s + at.t * at.t); };
  const ParameterPolygon pentagon{{0, 0}, {2, 0}, {3, 1}, {1, 3}, {0, 2}};
  const Enclosure one = integral_over_polygon(f, pentagon, demand);
  ASSERT_TRUE(one.has_value());
  const Enclosure other = integral_over_polygon(f, {{1, 3}, {3, 1}, {2, 0}, {0, 0}, {0, 2}}, demand);
  expect_value(other, one->value, 1e-22);
}

TEST(IntegralOverPolygon, HasTheValuesOfKnownIntegrals) {
  const BallPrecision precision(160);
  const Demand demand{.radius = 1e-30};
  // Int Int 1/(a + s + t) = (a+2) log(a+2) - 2 (a+1) log(a+1) + a log a; a pole close to the corner makes the
  // cells small.
  for (const char* text : {"1", "1/8", "1/1000"}) {
    SCOPED_TRACE(text);
    const Rational a = *Rational::parse(text);
    const auto f = [a]<class R>(const ParameterPoint<R>& at) {
      return R(1) / (from_rational<R>(a) + at.s + at.t);
    };
    const Ball b(a);
    expect_value(integral_over_polygon(f, square, demand),
                 (b + 2) * log(b + 2) - 2 * (b + 1) * log(b + 1) + b * log(b), 1e-30);
  }
}

TEST(IntegralOverPolygon, ContainsTheTruthAtEveryRadius) {
  const auto f = []<class R>(const ParameterPoint<R>& at) {
    return sqrt(R(1) + at.s * at.t) / (R(2) + sin(R(3) * at.s - at.t));
  };
  Ball truth;
  {
    const BallPrecision precision(200);
    const Enclosure found = integral_over_polygon(f, triangle, {.radius = 1e-40});
    ASSERT_TRUE(found.has_value()) << found.reason().to_text();
    truth = found->value;
  }
  for (const double radius : {1e-1, 1e-3, 1e-6, 1e-9, 1e-14, 1e-25}) {
    const BallPrecision precision(120);
    expect_value(integral_over_polygon(f, triangle, {.radius = radius}), truth, radius);
  }
}

TEST(IntegralOverPolygon, GivesTheSameBitsForEveryNumberOfThreads) {
  const auto f = []<class R>(const ParameterPoint<R>& at) {
    return R(1) / (R(1) / R(16) + at.s * at.s + at.t);
  };
  const auto bits = [&] {
    const Enclosure found = integral_over_polygon(f, square, {.radius = 1e-18});
    EXPECT_TRUE(found.has_value());
    const BinaryNumber midpoint = found->value.midpoint_binary();
    return midpoint.mantissa + " " + midpoint.exponent + " " + std::to_string(found->evaluations);
  };
  const std::string many = bits();
  const ThreadLimit one(1);
  EXPECT_EQ(many, bits());
}

TEST(IntegralOverPolygon, IntegratesRootsAndPowersUpToTheLineWhereTheyEnd) {
  const BallPrecision precision(128);
  const auto root = [](const auto& at) { return sqrt(at.s); };
  expect_value(integral_over_polygon(root, square, {.radius = 1e-15}), Ball(Rational(2, 3)), 1e-15);
  const auto power_of_s = []<class R>(const ParameterPoint<R>& at) { return pow(at.s, R(5) / R(2)) * at.t; };
  expect_value(integral_over_polygon(power_of_s, square, {.radius = 1e-15}), Ball(Rational(1, 7)), 1e-15);
}

TEST(IntegralOverPolygon, IsUndecidedOverAPoleOnALineOrAtAPoint) {
  const Demand demand{.radius = 1e-5, .work_limit = 100000};
  const auto on_a_line = []<class R>(const ParameterPoint<R>& at) { return R(1) / (at.s - R(1) / R(3)); };
  const auto at_a_point = []<class R>(const ParameterPoint<R>& at) {
    const R s = at.s - R(1) / R(3);
    const R t = at.t - R(1) / R(5);
    return R(1) / (s * s + t * t);
  };
  const auto logarithm = []<class R>(const ParameterPoint<R>& at) { return log(at.s - at.t); };
  const auto check = [&](const Enclosure& found) {
    ASSERT_FALSE(found.has_value()) << found->value.to_text();
    EXPECT_FALSE(found.reason().reached.is_finite());
    EXPECT_LE(found.reason().evaluations, demand.work_limit);
    EXPECT_FALSE(found.reason().why.empty());
  };
  check(integral_over_polygon(on_a_line, square, demand));
  check(integral_over_polygon(at_a_point, triangle, demand));
  check(integral_over_polygon(logarithm, square, demand));
}

TEST(IntegralOverPolygon, ObeysItsWorkLimitAndSaysWhatWasReached) {
  const auto kink = []<class R>(const ParameterPoint<R>& at) { return abs(at.s - at.t); };
  double before = 1;
  for (const long limit : {2000L, 20000L, 200000L}) {
    const Enclosure found = integral_over_polygon(kink, square, {.radius = 1e-12, .work_limit = limit});
    ASSERT_FALSE(found.has_value());
    const Undecided& reason = found.reason();
    EXPECT_LE(reason.evaluations, limit);
    EXPECT_TRUE(reason.reached.contains(Rational(1, 3))) << reason.reached.to_text();
    EXPECT_LT(reason.reached.radius(), before);
    before = reason.reached.radius();
    EXPECT_NE(reason.why.find("work limit"), std::string::npos) << reason.why;
  }
  expect_value(integral_over_polygon(kink, square, {.radius = 1e-3}), Ball(Rational(1, 3)), 1e-3);
}

TEST(IntegralOverPolygon, SaysWhenRoundingIsWiderThanTheDemand) {
  const BallPrecision precision(64);
  const auto f = [](const auto& at) { return exp(at.s); };
  const Enclosure found = integral_over_polygon(f, square, {.radius = 1e-25});
  ASSERT_FALSE(found.has_value());
  EXPECT_NE(found.reason().why.find("64 bits"), std::string::npos) << found.reason().why;
  EXPECT_TRUE(overlaps(found.reason().reached, exp(Ball(1)) - 1));
}

// Demands around what rounding leaves: what is given is as narrow as was demanded.
TEST(IntegralOverPolygon, IsAsNarrowAsDemandedOrUndecided) {
  const BallPrecision precision(64);
  const auto f = [](const auto& at) { return exp(at.s); };
  int undecided = 0;
  for (double radius = 1e-15; radius > 1e-20; radius /= 4) {
    const Enclosure found = integral_over_polygon(f, square, {.radius = radius});
    if (found.has_value())
      EXPECT_LE(found->value.radius(), radius);
    else
      ++undecided;
  }
  EXPECT_GT(undecided, 1);
  EXPECT_LT(undecided, 8);
}

TEST(IntegralOverPolygon, RefusesPolygonsWithoutAnArea) {
  const auto f = [](const auto& at) { return at.s; };
  EXPECT_THROW(static_cast<void>(integral_over_polygon(f, {{0, 0}, {1, 1}}, {.radius = 1})),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(integral_over_polygon(f, {{0, 0}, {1, 1}, {2, 2}}, {.radius = 1})),
               ContractViolation);
  EXPECT_THROW(
      static_cast<void>(integral_over_polygon(f, {{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}}, {.radius = 1})),
      ContractViolation);
}

TEST(SquareMaps, CoverAConvexPolygonFromEveryPointOfIt) {
  const ParameterPolygon pentagon{{0, 0}, {2, 0}, {3, 1}, {1, 3}, {0, 2}};
  const auto area = [](const std::vector<SquareMap>& maps) {
    Rational sum;
    for (const SquareMap& map : maps) {
      sum += abs(cross(map.first, map.along)) * (map.parallelogram ? Rational(1) : Rational(1, 2));
    }
    return sum;
  };
  EXPECT_EQ(area(square_maps(pentagon)), Rational(6));
  EXPECT_EQ(area(fan(pentagon, {1, 1})), Rational(6));
  EXPECT_EQ(area(fan(pentagon, {1, 0})), Rational(6));
  EXPECT_EQ(fan(pentagon, {1, 0}).size(), 4U);
  EXPECT_EQ(fan(pentagon, {2, 0}).size(), 3U);
  EXPECT_EQ(area(square_maps(square)), Rational(1));
  EXPECT_TRUE(square_maps(square).front().parallelogram);
  EXPECT_THROW(static_cast<void>(fan(pentagon, {3, 3})), ContractViolation);
}

TEST(BoundOnEllipse, BoundsTheFunctionOnTheEllipse) {
  // 1/(z - a) grows towards the pole: its largest value is that at the end of the long axis.
  const double a = 1.5;
  const SquareFunction f =
      square_function([]<class R>(const R& x, const R& y) { return (R(1) + R(0) * y) / (x - R(3) / R(2)); });
  const SquareCell cell{};
  const double singular = 2 + std::sqrt(3.0);  // (x - 1/2) / (1/2) = 2
  for (const double rho : {1.1, 1.7, 2.5, 3.3}) {
    const EllipseBound found = bound_on_ellipse(f, cell, SquareAxis::x, rho, 400);
    const double exact = 1 / (a - 0.5 - (rho + 1 / rho) / 4);
    EXPECT_GE(found.bound, exact * (1 - 1e-12)) << rho;
    EXPECT_LE(found.bound, 40 * exact) << rho;
  }
  const EllipseBound beyond = bound_on_ellipse(f, cell, SquareAxis::x, 1.01 * singular, 2000);
  EXPECT_FALSE(std::isfinite(beyond.bound));
  EXPECT_NE(beyond.failure, nullptr);
  // In the other variable there is no pole.
  const EllipseBound other = bound_on_ellipse(f, cell, SquareAxis::y, 50, 400);
  EXPECT_GE(other.bound, 2 * (1 - 1e-12));
  EXPECT_LE(other.bound, 40);
}

// exp(-4 x^2) on [-1/2, 1/2] moved to the cell: the largest value is that at the top of the ellipse.
TEST(BoundOnEllipse, BoundsWhatIsLargestAtTheTop) {
  const SquareFunction f = square_function([]<class R>(const R& x, const R& y) {
    const R from_middle = x - R(1) / R(2);
    return exp(R(-4) * from_middle * from_middle) + R(0) * y;
  });
  for (const double rho : {4.0, 6.0}) {
    const EllipseBound found = bound_on_ellipse(f, SquareCell{}, SquareAxis::x, rho, 4000);
    const double top = (rho - 1 / rho) / 4;
    EXPECT_GE(found.bound, std::exp(4 * top * top) * (1 - 1e-12)) << rho;
    EXPECT_LE(found.bound, 4 * std::exp(4 * top * top)) << rho;
  }
}

TEST(IntegralOverSquares, OfZeroIsZeroByFewNodes) {
  const SquareFunction zero = square_function([]<class R>(const R& x, const R& y) { return R(0) * x * y; });
  const Enclosure found = integral_over_squares(std::span(&zero, 1), {.radius = 1e-20});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(certainly_zero(found->value)) << found->value.to_text();
}

TEST(IntegralOverSquares, HoldsTheErrorOfTheRuleInEitherVariable) {
  // A pole beside the square in one variable, and nothing in the other: one of the two errors alone.
  int narrow = 0;
  for (const bool in_x : {true, false})
    for (const double gap : {0.03, 0.1, 0.5, 2.0})
      for (const double radius : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
        const auto f = [in_x, gap]<class R>(const R& x, const R& y) {
          return R(1) / ((in_x ? x : y) + from_rational<R>(Rational::exactly(gap)));
        };
        const std::vector<SquareFunction> functions{
            {.in_balls = [f](const Ball& x, const Ball& y) { return f(x, y); },
             .in_models = [f](const TaylorModel& x, const TaylorModel& y) { return f(x, y); }}};
        const Enclosure found = integral_over_squares(functions, {.radius = radius});
        ASSERT_TRUE(found) << found.reason().why;
        const Ball truth = log(Ball(1 + Rational(1) / Rational::exactly(gap)));
        EXPECT_TRUE(found->value.contains(truth)) << in_x << " " << gap << " " << radius << ": "
                                                  << found->value.to_text() << " " << truth.to_text();
        narrow += found->value.radius() < 0.5 * radius ? 1 : 0;
      }
  EXPECT_GT(narrow, 10);
}

}  // namespace
}  // namespace radcert
