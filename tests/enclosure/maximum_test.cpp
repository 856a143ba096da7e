// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/maximum.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/enclosure/domain_point.h"

namespace radcert {
namespace {

void expect_value(const Enclosure& found, const Ball& exact, double radius) {
  ASSERT_TRUE(found.has_value()) << found.reason().to_text();
  EXPECT_LE(found->value.radius(), radius);
  EXPECT_TRUE(overlaps(found->value, exact)) << found->value.to_text(30) << ", " << exact.to_text(30);
}

TEST(Maximum, IsFoundInsideOnASideAndAtACorner) {
  const BallPrecision precision(100);
  const Demand demand{.radius = 1e-15};
  // 1 - (x - 1/3)^2 - 2 (y - 1/7)^2
  const auto hill = cube_function(2, []<class T>(std::span<const T> x) {
    const T s = x[0] - T(Ball(Rational(1, 3)));
    const T t = x[1] - T(Ball(Rational(1, 7)));
    return T(1) - s * s - T(2) * (t * t);
  });
  expect_value(maximum(hill, demand), 1, 1e-15);
  // x (1 + y) - y^2: at x = 1, y = 1/2
  const auto side =
      cube_function(2, []<class T>(std::span<const T> x) { return x[0] * (T(1) + x[1]) - x[1] * x[1]; });
  expect_value(maximum(side, demand), Ball(Rational(5, 4)), 1e-15);
  const auto corner = cube_function(2, []<class T>(std::span<const T> x) { return exp(x[0] - x[1]); });
  expect_value(maximum(corner, demand), exp(Ball(1)), 1e-15);
}

TEST(Maximum, TakesOneThreeAndFourVariables) {
  const BallPrecision precision(80);
  const auto wave = cube_function(1, []<class T>(std::span<const T> x) { return sin(T(7) * x[0]) - x[0]; });
  // 7 cos(7x) = 1: x = acos(1/7) / 7.
  const Ball angle = atan(sqrt(Ball(48)));
  expect_value(maximum(wave, {.radius = 1e-12}), sin(angle) - angle / 7, 1e-12);
  const auto quadratic = [](std::size_t n) {
    return cube_function(n, [n]<class T>(std::span<const T> x) {
      T sum(0);
      for (std::size_t k = 0; k < n; ++k) {
        const T shifted = x[k] - T(Ball(Rational(1, static_cast<long>(k) + 3)));
        sum = sum - T(static_cast<int>(k) + 1) * (shifted * shifted);
      }
      return sum;
    });
  };
  expect_value(maximum(quadratic(3), {.radius = 1e-6}), 0, 1e-6);
  expect_value(maximum(quadratic(4), {.radius = 1e-4}), 0, 1e-4);
}

TEST(Maximum, IsTakenOverDomainsAndPairsOfThem) {
  const auto product = [](ChartDomain domain) {
    return cube_function(2, [domain]<class T>(std::span<const T> x) {
      const ParameterPoint<T> at = domain_point(domain, x[0], x[1]);
      return at.s * at.t;
    });
  };
  expect_value(maximum(product(ChartDomain::unit_square), {.radius = 1e-12}), 1, 1e-12);
  expect_value(maximum(product(ChartDomain::unit_triangle), {.radius = 1e-12}), Ball(0.25), 1e-12);
  // The distance of a point of the triangle to one of the square, at most sqrt(2), from the origin to (1,1)
  // or corner to corner.
  const auto distance = cube_function(4, []<class T>(std::span<const T> x) {
    const ParameterPoint<T> p = domain_point(ChartDomain::unit_triangle, x[0], x[1]);
    const ParameterPoint<T> q = domain_point(ChartDomain::unit_square, x[2], x[3]);
    const T s = p.s - q.s;
    const T t = p.t - q.t;
    return s * s + t * t;
  });
  expect_value(maximum(distance, {.radius = 1e-4}), 2, 1e-4);
}

TEST(Maximum, SeesANarrowPeak) {
  const auto peak = cube_function(2, []<class T>(std::span<const T> x) {
    const T s = x[0] - T(Ball(Rational(617, 1000)));
    const T t = x[1] - T(Ball(Rational(123, 1000)));
    return T(1) / (T(1) + T(1000000) * (s * s + t * t));
  });
  expect_value(maximum(peak, {.radius = 1e-10}), 1, 1e-10);
}

TEST(Maximum, HasNoNeedOfAGradientEverywhere) {
  const auto kink = cube_function(2, []<class T>(std::span<const T> x) {
    // x - x makes the range of a box wide: the mean value form must decide.
    return x[0] - abs(x[0] - T(Ball(Rational(3, 10)))) - abs(x[1] - x[0] - T(Ball(Rational(1, 7)))) - x[0];
  });
  expect_value(maximum(kink, {.radius = 1e-6}), 0, 1e-6);
}

TEST(Maximum, IsUndecidedWithBothBoundsAtTheWorkLimit) {
  const auto f =
      cube_function(2, []<class T>(std::span<const T> x) { return sin(T(20) * x[0]) * cos(T(30) * x[1]); });
  for (const long limit : {1L, 10L, 100L}) {
    const Enclosure found = maximum(f, {.radius = 1e-15, .work_limit = limit});
    ASSERT_FALSE(found.has_value());
    EXPECT_LE(found.reason().evaluations, limit);
    if (limit > 1) {
      EXPECT_TRUE(found.reason().reached.contains(Rational(1)) || found.reason().reached.upper_double() >= 1);
      EXPECT_LE(found.reason().reached.lower_double(), 1);
    }
  }
  const auto pole =
      cube_function(1, []<class T>(std::span<const T> x) { return T(1) / (x[0] - T(Ball(Rational(1, 3)))); });
  const Enclosure found = maximum(pole, {.radius = 1, .work_limit = 300});
  ASSERT_FALSE(found.has_value());
  EXPECT_FALSE(found.reason().reached.is_finite());
}

TEST(Maximum, NamesAContradictionBetweenValueAndGradient) {
  CubeFunction f = cube_function(1, []<class T>(std::span<const T> x) { return x[0] * (T(1) - x[0]); });
  f.gradient = [](std::span<const Ball> x) {
    if (certainly_at_most(x[0], Ball(0.5))) return std::vector<Ball>{Ball(1)};
    if (certainly_at_most(Ball(0.5), x[0])) return std::vector<Ball>{Ball(-1)};
    return std::vector<Ball>{hull(Ball(-1), Ball(1))};
  };
  EXPECT_THROW(static_cast<void>(maximum(f, {.radius = 1e-3})), ContractViolation);
  EXPECT_THROW(static_cast<void>(maximum(f, {.radius = 0})), ContractViolation);
}

}  // namespace
}  // namespace radcert
