// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/dilogarithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/scalar/functions/bernoulli_numbers.h"
#include "radcert/scalar/rational.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Reference = Mpfr<100>;

std::string shown(double radius, double angle) {
  return "r = " + shortest(radius) + ", phi = " + shortest(angle);
}

/// sum r^n sin(n phi) / n^2 until the rest is below 1e-55 of r: for r <= 0.9.
Reference series(const Reference& radius, const Reference& angle) {
  const Reference twice_cosine = Reference(2) * cos(angle);
  Reference before(0);
  Reference sine = sin(angle);
  Reference power = radius;
  Reference sum(0);
  const Reference small = radius * Reference(Rational::parse("1e-60").value());
  for (long n = 1; power > small; ++n) {
    sum += power * sine / Reference(n * n);
    const Reference next = twice_cosine * sine - before;
    before = sine;
    sine = next;
    power *= radius;
  }
  return sum;
}

/// A radius in [0, 1] and an angle, many of them near the branch point, the real axis, and the borders
/// between series.
struct Polar {
  double radius;
  double angle;
};

Polar draw_polar(Draw& draw) {
  Polar z{draw.unit(), (2 * draw.unit() - 1) * std::numbers::pi};
  switch (draw.below(6)) {
    case 0: z.radius = 1; break;
    case 1: z.radius = 1 - std::ldexp(draw.unit(), -static_cast<int>(draw.below(53))); break;
    case 2: z.radius = std::ldexp(draw.unit(), -static_cast<int>(draw.below(300))); break;
    case 3: z.radius = std::array{0.0, 0.5, 0.5 + 0x1p-53, 1 - 0x1p-53}[draw.below(4)]; break;
    default: break;
  }
  const double sign = draw.below(2) == 0 ? 1 : -1;
  switch (draw.below(6)) {
    case 0: z.angle = sign * std::ldexp(draw.unit(), -static_cast<int>(draw.below(300))); break;
    case 1:
      z.angle = sign * (std::numbers::pi - std::ldexp(draw.unit(), -static_cast<int>(draw.below(50))));
      break;
    case 2: {
      constexpr double pi = std::numbers::pi;
      z.angle = sign * std::array{0.0, pi, pi / 2, pi / 3, std::nextafter(pi / 3, 0)}[draw.below(5)];
      break;
    }
    default: break;
  }
  return z;
}

TEST(BernoulliNumbers, HaveTheirRecurrence) {
  // sum_(j <= n) binom(n+1, j) B_j = 0, B_0 = 1, B_1 = -1/2, and the others of odd order 0.
  const auto of_order = [](std::size_t n) {
    if (n < 2) return n == 0 ? Rational(1) : Rational(-1, 2);
    if (n % 2 != 0) return Rational(0);
    const auto& [numerator, denominator] = bernoulli_numbers[n / 2 - 1];
    return Rational::exactly(numerator) / Rational::exactly(denominator);
  };
  for (std::size_t n = 1; n <= 2 * bernoulli_numbers.size(); ++n) {
    Rational sum;
    Rational binomial = 1;
    for (std::size_t j = 0; j <= n; ++j) {
      sum += binomial * of_order(j);
      binomial *= Rational(n + 1 - j) / Rational(j + 1);
    }
    EXPECT_EQ(sum.sign(), 0) << n;
  }
}

TEST(DilogarithmImaginary, IsCatalansAndGiesekingsConstant) {
  const BallPrecision precision(200);
  const Ball catalan =
      Ball::parse("0.915965594177219015054603514932384110774149374281672134266498 +/- 1e-60").value();
  const Ball at_catalan = dilogarithm_imaginary(Ball(1), Ball::pi() / 2);
  EXPECT_TRUE(overlaps(at_catalan, catalan)) << at_catalan.to_text(60);
  EXPECT_LT(at_catalan.radius(), 1e-57);
  const Ball gieseking =
      Ball::parse("1.0149416064096536250212025542745202859416893075302997920174891 +/- 1e-60").value();
  EXPECT_TRUE(overlaps(dilogarithm_imaginary(Ball(1), Ball::pi() / 3), gieseking));
  EXPECT_DOUBLE_EQ(dilogarithm_imaginary(1.0, std::numbers::pi / 2), 0.91596559417721901505);
  EXPECT_DOUBLE_EQ(dilogarithm_imaginary(1.0, -std::numbers::pi / 3), -1.0149416064096536250);
}

TEST(DilogarithmImaginary, IsTheSumOfItsSeries) {
  Draw draw(1);
  const Reference tolerance(Rational::parse("1e-55").value());
  for (int i = 0; i < 200; ++i) {
    const Polar z = draw_polar(draw);
    const double radius = std::min(z.radius, 0.9);
    const Reference expected = series(Reference(radius), Reference(z.angle));
    const Reference value = dilogarithm_imaginary(Reference(radius), Reference(z.angle));
    EXPECT_LE(abs(value - expected), tolerance * Reference(radius)) << shown(radius, z.angle);
    const BallPrecision precision(150);
    const Ball ball = dilogarithm_imaginary(Ball(radius), Ball(z.angle));
    EXPECT_TRUE(widened(ball, Ball(radius) * power(Ball(10), -55)).contains(expected.to_rational()))
        << shown(radius, z.angle);
  }
}

TEST(DilogarithmImaginary, DoublesAreWithinSixUnitsOfTheLastPlace) {
  Draw draw(2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Polar z = draw_polar(draw);
    const double value = dilogarithm_imaginary(z.radius, z.angle);
    const BallPrecision precision(96);
    const Ball exact = dilogarithm_imaginary(Ball(z.radius), Ball(z.angle));
    const double unit = std::nextafter(std::abs(value), HUGE_VAL) - std::abs(value);
    const double error = abs(Ball(value) - exact).upper_double() / unit;
    worst = std::max(worst, error);
    ASSERT_LE(error, 6) << shown(z.radius, z.angle);
  }
  RecordProperty("worst_units", shortest(worst));
}

TEST(DilogarithmImaginary, BallsAreNarrow) {
  Draw draw(3);
  for (int i = 0; i < 2000; ++i) {
    const Polar z = draw_polar(draw);
    const long bits = std::array{24L, 64L, 128L}[draw.below(3)];
    const BallPrecision precision(bits);
    const Ball value = dilogarithm_imaginary(Ball(z.radius), Ball(z.angle));
    ASSERT_TRUE(value.is_finite()) << shown(z.radius, z.angle);
    ASSERT_GE(value.accurate_bits(), bits - 3) << shown(z.radius, z.angle) << ": " << value.to_text();
  }
}

TEST(DilogarithmImaginary, BallsOfLargeAnglesContainTheValue) {
  for (const int exponent : {20, 50, 60, 70, 75, 80, 90, 100, 150, 200, 500})
    for (int k = 0; k < 25; ++k)
      for (const double radius : {0.9, 1.0}) {
        const double angle = std::ldexp(1 + 0.0377 * k, exponent);
        const auto value = [&](long bits) {
          const BallPrecision precision(bits);
          return dilogarithm_imaginary(Ball(radius), Ball(angle));
        };
        const Ball exact = value(900);
        ASSERT_LT(exact.radius(), 1e-30);
        for (const long bits : {53L, 128L}) {
          const Ball found = value(bits);
          EXPECT_TRUE(found.is_finite()) << shown(radius, angle);
          EXPECT_TRUE(overlaps(found, exact)) << bits << " bits, " << shown(radius, angle);
          EXPECT_LE(found.radius(), 1.03) << bits << " bits, " << shown(radius, angle);
        }
      }
}

TEST(DilogarithmImaginary, EnclosesEveryPointOfWideBalls) {
  Draw draw(4);
  for (int i = 0; i < 1000; ++i) {
    const Polar z = draw_polar(draw);
    const double wide_radius = std::ldexp(draw.unit(), -static_cast<int>(draw.below(60)));
    const double wide_angle = std::ldexp(draw.unit(), 2 - static_cast<int>(draw.below(60)));
    const BallPrecision precision(64);
    const Ball radius = widened(Ball(z.radius), Ball(wide_radius));
    const Ball angle = widened(Ball(z.angle), Ball(wide_angle));
    const Ball value = dilogarithm_imaginary(radius, angle);
    ASSERT_TRUE(value.is_finite());
    for (int k = 0; k < 4; ++k) {
      const BallPrecision exactly(1000);
      const Ball r = Ball(z.radius) + Ball(2 * draw.unit() - 1) * Ball(wide_radius);
      const Ball phi = Ball(z.angle) + Ball(2 * draw.unit() - 1) * Ball(wide_angle);
      const BallPrecision moderately(128);
      ASSERT_TRUE(overlaps(value, dilogarithm_imaginary(min(max(r, Ball(0)), Ball(1)), phi)))
          << shown(r.to_double(), phi.to_double());
    }
    // First order: |df/dr| <= pi/2 and |df/dphi| <= max(log 2, -log|1 - z|), at most log 4 + log(pi/width) on
    // average.
    EXPECT_LE(value.radius(), 2 * wide_radius + wide_angle * (3 + std::abs(std::log(wide_angle))) + 3e-18);
  }
}

TEST(DilogarithmImaginary, StaysFiniteAroundTheBranchPoint) {
  const BallPrecision precision(64);
  const Ball tiny = widened(Ball(), power(Ball(2), -60));
  const Ball value = dilogarithm_imaginary(1 + tiny, tiny);
  ASSERT_TRUE(value.is_finite());
  EXPECT_TRUE(value.contains(0.0));
  EXPECT_LT(value.radius(), 1e-15);
  EXPECT_TRUE(certainly_zero(dilogarithm_imaginary(Ball(1), Ball(0))));
  EXPECT_TRUE(dilogarithm_imaginary(Ball(1), 2 * Ball::pi()).contains(0.0));
}

TEST(DilogarithmImaginary, ObeysDuplication) {
  // Li_2(z^2) = 2 Li_2(z) + 2 Li_2(-z)
  Draw draw(5);
  const BallPrecision precision(128);
  for (int i = 0; i < 300; ++i) {
    const Polar z = draw_polar(draw);
    const Ball radius(z.radius);
    const Ball angle(z.angle);
    const Ball once = dilogarithm_imaginary(power(radius, 2), 2 * angle);
    const Ball twice =
        2 * (dilogarithm_imaginary(radius, angle) + dilogarithm_imaginary(radius, angle + Ball::pi()));
    ASSERT_TRUE(overlaps(once, twice)) << shown(z.radius, z.angle);
  }
}

TEST(DilogarithmImaginary, HasPeriodTwoPiAndIsOdd) {
  Draw draw(6);
  for (int i = 0; i < 300; ++i) {
    const Polar z = draw_polar(draw);
    EXPECT_EQ(dilogarithm_imaginary(z.radius, -z.angle), -dilogarithm_imaginary(z.radius, z.angle));
    const BallPrecision precision(128);
    const Ball angle(z.angle);
    const long turns = static_cast<long>(draw.below(7)) - 3;
    EXPECT_TRUE(overlaps(dilogarithm_imaginary(Ball(z.radius), angle),
                         dilogarithm_imaginary(Ball(z.radius), angle + 2 * turns * Ball::pi())))
        << shown(z.radius, z.angle);
    const double far = 20 * (draw.unit() - 0.5);
    const double value = dilogarithm_imaginary(z.radius, far);
    EXPECT_LE(abs(Ball(value) - dilogarithm_imaginary(Ball(z.radius), Ball(far))).upper_double(),
              6 * 0x1p-52 * std::abs(value));
  }
}

TEST(DilogarithmImaginary, MpfrAgreesWithBalls) {
  Draw draw(7);
  for (int i = 0; i < 300; ++i) {
    const Polar z = draw_polar(draw);
    const Mpfr<50> value = dilogarithm_imaginary(Mpfr<50>(z.radius), Mpfr<50>(z.angle));
    const BallPrecision precision(256);
    const Ball exact = dilogarithm_imaginary(Ball(z.radius), Ball(z.angle));
    // Half a unit in the last place is at most 2^-bits of the value.
    const Ball allowed = Ball(1.001) * power(Ball(2), -Mpfr<50>::bits) * abs(exact);
    EXPECT_TRUE(widened(exact, allowed).contains(value.to_rational())) << shown(z.radius, z.angle);
  }
}

TEST(DilogarithmImaginary, RefusesWhatLiesOutside) {
  EXPECT_THROW((void)dilogarithm_imaginary(1 + 0x1p-52, 1.0), ContractViolation);
  EXPECT_THROW((void)dilogarithm_imaginary(-1e-300, 1.0), ContractViolation);
  EXPECT_THROW((void)dilogarithm_imaginary(std::nan(""), 1.0), ContractViolation);
  EXPECT_THROW((void)dilogarithm_imaginary(0.5, HUGE_VAL), ContractViolation);
  EXPECT_THROW((void)dilogarithm_imaginary(Mpfr<50>(2), Mpfr<50>(1)), ContractViolation);
  EXPECT_FALSE(dilogarithm_imaginary(Ball(2), Ball(1)).is_finite());
  EXPECT_FALSE(dilogarithm_imaginary(Ball(-1), Ball(1)).is_finite());
  EXPECT_EQ(dilogarithm_imaginary(Ball::failed("as it was"), Ball(1)).failure(), "as it was");
}

TEST(DilogarithmImaginary, HasABoundWhereItCannotTellTheAngleFromATurn) {
  // An angle 10^-60 beyond a whole turn, seen with fewer digits than that.
  Ball angle;
  Ball truth;
  {
    const BallPrecision precision(400);
    angle = (2 * Ball::pi() + Ball(Rational(1) / power(Rational(10), 60))).midpoint();
    truth = dilogarithm_imaginary(Ball(1), angle);
  }
  const BallPrecision precision(64);
  const Ball found = dilogarithm_imaginary(Ball(1), angle);
  EXPECT_TRUE(overlaps(found, truth)) << found.to_text() << " " << truth.to_text();
  EXPECT_TRUE(truth.accurate_bits() > 50);
  EXPECT_LE(found.radius(), 1e-15);
}

}  // namespace
}  // namespace radcert
