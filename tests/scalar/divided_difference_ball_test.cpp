// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "radcert/scalar/functions/power_difference.h"
#include "radcert/scalar/mpfr_real.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Fine = Mpfr<200>;
static_assert(Field<DividedDifference<Ball>> && Field<DividedDifference<Mpfr<50>>>);

const std::vector<Rational> exponents{Rational(3, 2), Rational(7, 3), Rational(5, 4), Rational(17, 3),
                                      Rational(101, 2)};

/// phi[a,b] and phi[a,a,b] of phi(x) = x^e from the definition; for b = a the derivatives. 200 digits leave
/// 100 for steps of 10^-50 and more.
struct Truth {
  Fine first;
  Fine bend;
};
Truth truth(const Fine& a, const Fine& b, const Fine& e) {
  const Fine d = b - a;
  const Fine slope = e * pow(a, e - 1);
  if (d == 0) return {slope, e * (e - 1) / 2 * pow(a, e - 2)};
  const Fine first = (pow(b, e) - pow(a, e)) / d;
  return {first, (first - slope) / d};
}

bool contains(const Ball& ball, const Fine& value) {
  return !ball.is_finite() ||
         overlaps(ball, widened(Ball(value.to_rational()),
                                Ball(abs(value).to_rational() * power(Rational(10), -60))));
}

TEST(PowerDifference, EnclosesTheDividedDifferencesOfPoints) {
  for (const Rational& exponent : exponents) {
    const Fine e(exponent);
    const BallPrecision precision(140);
    for (const double a : {0.7, 1e-3, 30.0})
      for (const double factor : {0.0, 0x1p-160, 0x1p-40, -0x1p-20, 0x1p-10, -0.2, 0.49, 0.51, 0.74, 0.76,
                                  -0.49, -0.51, -0.74, -0.76, -0.9, -1.0, 3.0, 200.0}) {
        const Rational step = Rational::exactly(a) * Rational::exactly(factor);
        const Rational b = Rational::exactly(a) + step;
        const Ball bend = bend_of_power(Ball(a), Ball(b), Ball(step), Ball(exponent));
        const Ball first = first_of_power(Ball(a), Ball(b), Ball(step), Ball(exponent), bend);
        const Truth value = truth(Fine(a), Fine(b), e);
        SCOPED_TRACE(exponent.to_text() + " " + shortest(a) + " " + shortest(factor));
        EXPECT_TRUE(bend.is_finite() && contains(bend, value.bend))
            << bend.to_text(40) << " " << value.bend.to_text(40);
        EXPECT_TRUE(first.is_finite() && contains(first, value.first)) << first.to_text(40);
        // No digits are lost as the step goes to zero, a few in the middle.
        EXPECT_GT(bend.accurate_bits(), exponent < Rational(10) ? 128 : 100) << bend.to_text(40);
        EXPECT_GT(first.accurate_bits(), 128) << first.to_text(40);
      }
  }
}

TEST(PowerDifference, EnclosesThoseOfAllPointsOfWideBalls) {
  Draw draw(51);
  int finite = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Rational exponent = exponents[draw.below(exponents.size())];
    const Fine e(exponent);
    const double a_low = draw.below(4) == 0 ? 0 : 2 * draw.unit();
    const double a_high = a_low + std::ldexp(draw.unit(), -static_cast<int>(draw.below(30)));
    double d_low = (2 * draw.unit() - 1) * std::ldexp(1, -static_cast<int>(draw.below(20)));
    d_low = std::max(d_low, -a_low);
    const double d_high = d_low + std::ldexp(draw.unit(), -static_cast<int>(draw.below(30)));
    const Ball a = hull(Ball(a_low), Ball(a_high));
    const Ball d = hull(Ball(d_low), Ball(d_high));
    // As the exact lower end is known, so that a ball beyond zero does not hide everything.
    const Ball b = hull(Ball(Rational::exactly(a_low) + Rational::exactly(d_low)), (a + d).upper());
    const Ball bend = bend_of_power(a, b, d, Ball(exponent));
    const Ball first = first_of_power(a, b, d, Ball(exponent), bend);
    finite += bend.is_finite() ? 1 : 0;
    SCOPED_TRACE(exponent.to_text() + " " + a.to_text() + " " + d.to_text());
    if (a_low == 0 && d_low == 0 && exponent < Rational(2)) {
      ASSERT_FALSE(bend.is_finite());
    }
    for (int sample = 0; sample < 6; ++sample) {
      const Fine x =
          sample == 0 ? Fine(a_low) : Fine(std::min(a_high, a_low + (a_high - a_low) * draw.unit()));
      const Fine step =
          sample == 1 ? Fine(d_low) : Fine(std::min(d_high, d_low + (d_high - d_low) * draw.unit()));
      if (x == 0 && step == 0) continue;
      const Truth value = truth(x, x + step, e);
      ASSERT_TRUE(contains(first, value.first)) << first.to_text() << " " << value.first.to_text(20);
      if (!value.bend.is_finite()) {
        ASSERT_FALSE(bend.is_finite());
        continue;
      }
      ASSERT_TRUE(contains(bend, value.bend)) << bend.to_text() << " " << value.bend.to_text(20);
    }
  }
  EXPECT_GT(finite, 2000);
}

const WorkLimit& limit_named(const std::string& name) {
  for (const WorkLimit* limit : work_limits())
    if (limit->name() == name) return *limit;
  throw std::runtime_error("no limit of work has the name " + name);
}

TEST(PowerDifference, BoundsWhatItsSeriesLeavesOut) {
  // One term alone: what is left out is of its size, and for negative exponents larger.
  const LoweredWorkLimit one(
      limit_named("scalar/power_difference: terms of the binomial series for each bit"), 0);
  for (const Rational& exponent :
       {Rational(-3), Rational(-1, 2), Rational(1, 2), Rational(3, 2), Rational(7, 3)})
    for (const double step : {-0.7, -0.5, -0.25, 0.25, 0.5, 0.7}) {
      const Ball bend = bend_of_power(Ball(1), Ball(1 + Rational::exactly(step)), Ball(step), Ball(exponent));
      const Truth value = truth(Fine(1), Fine(1) + Fine(step), Fine(exponent));
      EXPECT_TRUE(bend.is_finite() && contains(bend, value.bend))
          << exponent.to_text() << " " << step << ": " << bend.to_text() << " " << value.bend.to_text(20);
    }
}

TEST(DividedDifferenceBall, EnclosesRootsPowersAndQuotients) {
  Draw draw(52);
  using D = DividedDifference<Ball>;
  const auto f = []<class R>(const DividedDifference<R>& x, const Exponent<R>& e) {
    return power(R(1) + x * x, e) / (R(2) + x) - sqrt(R(3) + x);
  };
  const auto value = [](const Fine& x, const Fine& e) { return pow(1 + x * x, e) / (2 + x) - sqrt(3 + x); };
  for (int trial = 0; trial < 300; ++trial) {
    const Rational exponent = exponents[draw.below(4)];
    const double p = draw.unit();
    const double q = p + std::ldexp(draw.unit(), -static_cast<int>(draw.below(90)));
    const double step = q - p;
    const D g = f(D::variable(Ball(p), Ball(1), Ball(step)), Exponent<Ball>(exponent));
    const Fine e(exponent);
    const Fine h = power(Fine(10), -60);
    const Fine x(p);
    const Fine y = Fine(p) + Fine(step);
    const Fine slope = (value(x + h, e) - value(x - h, e)) / (2 * h);
    SCOPED_TRACE(exponent.to_text() + " " + shortest(p) + " " + shortest(step));
    ASSERT_TRUE(contains(g.slope_p, slope)) << g.slope_p.to_text();
    if (step == 0) continue;
    const Fine first = (value(y, e) - value(x, e)) / (y - x);
    ASSERT_TRUE(contains(g.first, first)) << g.first.to_text();
    ASSERT_GT(g.first.accurate_bits(), 100);
    const Fine second = (first - slope) / (y - x);
    if (step > 1e-20) {
      ASSERT_TRUE(contains(g.second_p, second)) << g.second_p.to_text() << " " << second.to_text(30);
    }
    ASSERT_GT(g.second_p.accurate_bits(), 100);
  }
}

TEST(DividedDifferenceBall, KeepsItsStepBesideConstants) {
  using D = DividedDifference<Ball>;
  const D x = D::variable(Ball(0.5), Ball(2), hull(Ball(-1), Ball(1)));
  EXPECT_TRUE((D(1) + x).step.contains(0.75) && (x * D(3)).step.contains(-0.75));
}

TEST(DividedDifferenceBall, AlongTheSingularLineOfAPowerIsZero) {
  using D = DividedDifference<Ball>;
  const D f = power(D::variable(Ball(0), Ball(0), Ball(1)), Exponent<Ball>(Rational(3, 2)));
  EXPECT_TRUE(certainly_zero(f.first) && certainly_zero(f.second_p) && certainly_zero(f.second_q));
  // A step of zero at the singular point is not that: the second difference has no bound.
  const D g = power(D::variable(Ball(0), Ball(1), Ball(0)), Exponent<Ball>(Rational(3, 2)));
  EXPECT_FALSE(g.second_p.is_finite());
  EXPECT_TRUE(g.first.contains(0.0));
}

TEST(DividedDifferenceMpfr, OfAFractionalPowerLosesFewDigitsAtAnyStep) {
  using R = Mpfr<50>;
  for (const Rational& exponent : {Rational(3, 2), Rational(7, 3), Rational(5, 4), Rational(17, 3)})
    for (const double p : {0.7, 1e-3})
      for (const double factor :
           {0x1p-100, 0x1p-30, -0x1p-10, -0.2, 0.4999, 0.5001, -0.4999, -0.5001, -0.9, 3.0}) {
        const R step = R(p) * R(factor);
        const auto f = power(DividedDifference<R>::variable(R(p), R(1), step), Exponent<R>(exponent));
        const Fine a(p);
        const Fine b = a + Fine(step.to_rational());
        const Truth of_p = truth(a, b, Fine(exponent));
        const Truth of_q = truth(b, a, Fine(exponent));
        SCOPED_TRACE(exponent.to_text() + " " + shortest(p) + " " + shortest(factor));
        EXPECT_LE(abs(Fine(f.second_p.to_rational()) / of_p.bend - 1), Fine(1e-44));
        EXPECT_LE(abs(Fine(f.second_q.to_rational()) / of_q.bend - 1), Fine(1e-44));
        EXPECT_LE(abs(Fine(f.first.to_rational()) / of_p.first - 1), Fine(1e-44));
      }
}

}  // namespace
}  // namespace radcert
