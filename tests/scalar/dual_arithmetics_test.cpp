// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/dual.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/pack.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Fine = Mpfr<200>;

static_assert(Real<Dual<double>> && Real<Dual<Pack>> && Real<Dual<Mpfr<50>>> && Real<Dual<Ball>>);
static_assert(Enclosing<Dual<Ball>> && !Enclosing<Dual<double>>);

/// One formula in s and t, in every arithmetic.
struct Formula {
  const char* name;
  std::function<double(double, double)> in_double;
  std::function<Fine(const Fine&, const Fine&)> in_fine;
  std::function<Dual<double>(const Dual<double>&, const Dual<double>&)> in_dual_double;
  std::function<Dual<Pack>(const Dual<Pack>&, const Dual<Pack>&)> in_dual_pack;
  std::function<Dual<Mpfr<50>>(const Dual<Mpfr<50>>&, const Dual<Mpfr<50>>&)> in_dual_mpfr;
  std::function<Dual<Ball>(const Dual<Ball>&, const Dual<Ball>&)> in_dual_ball;
};

template <class F>
Formula formula(const char* name, F f) {
  return {name, f, f, f, f, f, f};
}

std::vector<Formula> formulas() {
  return {
      formula("quotient", [](const auto& s, const auto& t) { return s / (t + s * t); }),
      formula("sqrt",
              [](const auto& s, const auto& t) {
                using std::sqrt;
                return sqrt(s * s + t);
              }),
      formula("exp",
              [](const auto& s, const auto& t) {
                using std::exp;
                return exp(s * t - s);
              }),
      formula("log",
              [](const auto& s, const auto& t) {
                using std::log;
                return log(s + t * t);
              }),
      formula("sin",
              [](const auto& s, const auto& t) {
                using std::sin;
                return sin(s * t + t);
              }),
      formula("cos",
              [](const auto& s, const auto& t) {
                using std::cos;
                return cos(s - t * t);
              }),
      formula("tan",
              [](const auto& s, const auto& t) {
                using std::tan;
                return tan(s * t);
              }),
      formula("atan",
              [](const auto& s, const auto& t) {
                using std::atan;
                return atan(s / t);
              }),
      formula("pow",
              [](const auto& s, const auto& t) {
                using std::pow;
                return pow(s, t + s);
              }),
      formula("constant exponent",
              [](const auto& s, const auto& t) {
                using std::pow;
                using T = std::decay_t<decltype(s + t)>;
                return pow(s * t, T(5) / T(2)) - pow(-s, T(3));
              }),
      formula("whole power",
              [](const auto& s, const auto& t) {
                return power(s - t, 5) + power(s, -2) - power(t, 1) + power(t, 0);
              }),
      formula("abs",
              [](const auto& s, const auto& t) {
                using std::abs;
                return abs(s - 2 * t) + abs(s + t);
              }),
      formula("min", [](const auto& s, const auto& t) { return smaller_of(s * s, t) + larger_of(s, t * t); }),
  };
}

/// 2 * t in the formulas above.
template <class R>
Dual<R> operator*(int c, const Dual<R>& f) {
  return R(c) * f;
}

/// Whether a ball contains a number known to 100 decimals: the difference quotient is off by 10^-119 or so,
/// the radius by 2^-128 = 10^-39.
bool contains(const Ball& ball, const Fine& truth) {
  return overlaps(ball, widened(Ball(truth.to_rational()), Ball(1e-100)));
}

/// The derivative along (a, b), by the symmetric difference with a step of 10^-60.
Fine slope(const Formula& f, double s, double t, int a, int b) {
  const Fine step = power(Fine(10), -60);
  return (f.in_fine(Fine(s) + a * step, Fine(t) + b * step) -
          f.in_fine(Fine(s) - a * step, Fine(t) - b * step)) /
         (2 * step);
}

TEST(DualArithmetics, DifferentiateAlike) {
  Draw draw(41);
  for (const Formula& f : formulas())
    for (int trial = 0; trial < 40; ++trial) {
      const double s = 0.05 + draw.unit();
      const double t = 0.05 + draw.unit();
      SCOPED_TRACE(std::string(f.name) + " at " + shortest(s) + ", " + shortest(t));
      const Fine value = f.in_fine(Fine(s), Fine(t));
      const Fine by_s = slope(f, s, t, 1, 0);
      const Fine by_t = slope(f, s, t, 0, 1);

      const auto in_double = f.in_dual_double({s, 1, 0}, {t, 0, 1});
      const double size =
          1 + std::abs(by_s.to_double()) + std::abs(by_t.to_double()) + std::abs(value.to_double());
      ASSERT_NEAR(in_double.value, value.to_double(), 1e-13 * size);
      ASSERT_NEAR(in_double.by_s, by_s.to_double(), 1e-12 * size);
      ASSERT_NEAR(in_double.by_t, by_t.to_double(), 1e-12 * size);

      const auto in_pack = f.in_dual_pack({Pack(s), Pack(1), Pack(0)}, {Pack(t), Pack(0), Pack(1)});
      for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
        ASSERT_EQ(in_pack.value.lane(lane), in_double.value);
        ASSERT_EQ(in_pack.by_s.lane(lane), in_double.by_s);
        ASSERT_EQ(in_pack.by_t.lane(lane), in_double.by_t);
      }

      using M = Mpfr<50>;
      const auto in_mpfr = f.in_dual_mpfr({M(s), M(1), M(0)}, {M(t), M(0), M(1)});
      const Fine near = Fine(1e-45) * Fine(size);
      ASSERT_LE(abs(Fine(in_mpfr.value.to_rational()) - value), near);
      ASSERT_LE(abs(Fine(in_mpfr.by_s.to_rational()) - by_s), near);
      ASSERT_LE(abs(Fine(in_mpfr.by_t.to_rational()) - by_t), near);

      const auto in_ball = f.in_dual_ball({Ball(s), 1, 0}, {Ball(t), 0, 1});
      const auto encloses = [&](const Ball& ball, const Fine& truth) {
        return contains(ball, truth) && ball.radius() < 1e-34 * size;
      };
      ASSERT_TRUE(encloses(in_ball.value, value)) << in_ball.value.to_text(50);
      ASSERT_TRUE(encloses(in_ball.by_s, by_s)) << in_ball.by_s.to_text(50) << " " << by_s.to_text();
      ASSERT_TRUE(encloses(in_ball.by_t, by_t)) << in_ball.by_t.to_text(50) << " " << by_t.to_text();
    }
}

TEST(DualArithmetics, OfABallEncloseTheDerivativesAtItsPoints) {
  Draw draw(42);
  int finite = 0;
  for (const Formula& f : formulas())
    for (int trial = 0; trial < 60; ++trial) {
      const double s = 0.05 + draw.unit();
      const double t = 0.05 + draw.unit();
      const double width = std::ldexp(draw.unit(), -static_cast<int>(draw.below(12)));
      const Ball wide_s = hull(Ball(s), Ball(s + width));
      const Ball wide_t = hull(Ball(t), Ball(t + width));
      const auto in_ball = f.in_dual_ball({wide_s, 1, 0}, {wide_t, 0, 1});
      finite += in_ball.value.is_finite() && in_ball.by_s.is_finite() ? 1 : 0;
      SCOPED_TRACE(std::string(f.name) + " at " + wide_s.to_text() + ", " + wide_t.to_text());
      for (int sample = 0; sample < 5; ++sample) {
        const double a = std::min(s + width, s + width * draw.unit());
        const double b = std::min(t + width, t + width * draw.unit());
        ASSERT_TRUE(contains(in_ball.value, f.in_fine(Fine(a), Fine(b))));
        ASSERT_TRUE(contains(in_ball.by_s, slope(f, a, b, 1, 0))) << in_ball.by_s.to_text();
        ASSERT_TRUE(contains(in_ball.by_t, slope(f, a, b, 0, 1))) << in_ball.by_t.to_text();
      }
    }
  EXPECT_GT(finite, 600);
}

TEST(DualArithmetics, OfABallThatStraddlesHaveBothDerivatives) {
  const Dual<Ball> around{hull(Ball(-1), Ball(2)), 3, -1};
  const Dual<Ball> size = abs(around);
  EXPECT_TRUE(size.by_s.contains(3.0) && size.by_s.contains(-3.0));
  EXPECT_TRUE(size.by_t.contains(1.0) && size.by_t.contains(-1.0));
  EXPECT_LT(size.by_s.radius(), 3.001);
  EXPECT_GE(size.value.lower_double(), 0);
  const Dual<Ball> at_zero = abs(Dual<Ball>{0, 1, 0});
  EXPECT_TRUE(at_zero.by_s.contains(1.0) && at_zero.by_s.contains(-1.0));
  EXPECT_FALSE(abs(Dual<Ball>{hull(Ball(1), Ball(2)), 3, -1}).by_s.contains(-3.0));
  EXPECT_FALSE(abs(Dual<Ball>{hull(Ball(-2), Ball(-1)), 3, -1}).by_s.contains(3.0));

  const Dual<Ball> other{hull(Ball(1), Ball(5)), 7, 0};
  for (const Dual<Ball>& either :
       {min(around, other), max(around, other), min(other, around), max(other, around)}) {
    EXPECT_TRUE(either.by_s.contains(3.0) && either.by_s.contains(7.0));
    EXPECT_TRUE(either.by_t.contains(-1.0) && either.by_t.contains(0.0));
  }
  const Dual<Ball> above{hull(Ball(3), Ball(5)), 7, 0};
  EXPECT_FALSE(min(around, above).by_s.contains(7.0));
  EXPECT_FALSE(max(around, above).by_s.contains(3.0));
  const Dual<Ball> both = hull(around, above);
  EXPECT_TRUE(both.value.contains(4.0) && both.by_s.contains(5.0));
}

TEST(DualArithmetics, TakeTheFirstBranchAtATie) {
  const Dual<double> f{1, 2, 3};
  const Dual<double> g{1, 5, 7};
  EXPECT_EQ(min(f, g).by_s, 2);
  EXPECT_EQ(max(f, g).by_s, 2);
  EXPECT_EQ(abs(Dual<double>{0, 2, 3}).by_s, 2);
  EXPECT_EQ(abs(Dual<double>{-1, 2, 3}).by_t, -3);
  const Dual<double> nan{std::numeric_limits<double>::quiet_NaN(), 0, 0};
  EXPECT_TRUE(std::isnan(min(f, nan).value) && std::isnan(min(nan, f).value));
  EXPECT_TRUE(std::isnan(max(f, nan).value) && std::isnan(max(nan, f).value));
  EXPECT_TRUE(std::isnan(abs(nan).value));
}

TEST(DualArithmetics, OfRationalsHaveAbsMinAndMax) {
  using D = Dual<Rational>;
  const D f{Rational(1, 3), 2, 3};
  const D g{Rational(1, 2), 5, 7};
  EXPECT_EQ(min(f, g).by_s, Rational(2));
  EXPECT_EQ(max(f, g).by_s, Rational(5));
  EXPECT_EQ(abs(-f).value, Rational(1, 3));
  EXPECT_EQ(abs(-f).by_t, Rational(3));
  EXPECT_EQ(power(f, 3).by_s, Rational(2, 3));
  EXPECT_EQ(power(f, -1).by_s, Rational(-18));
}

TEST(DualArithmetics, PowerWithAConstantExponentHasNoLogarithm) {
  const Dual<double> zero{0, 1, 0};
  EXPECT_EQ(pow(zero, Dual<double>(2.5)).by_s, 0);
  EXPECT_EQ(pow(zero, Dual<double>(1)).by_s, 1);
  EXPECT_EQ(pow(zero, Dual<double>(0)).by_s, 0);
  EXPECT_EQ(pow(Dual<double>{-2, 1, 0}, Dual<double>(3)).by_s, 12);
  const Dual<Ball> from_zero{hull(Ball(0), Ball(1)), 1, 0};
  const Dual<Ball> root = pow(from_zero, Dual<Ball>(Ball(1.5)));
  EXPECT_TRUE(root.by_s.contains(0.0) && root.by_s.contains(1.5));
  EXPECT_LT(root.by_s.upper_double(), 1.501);
  EXPECT_FALSE(pow(from_zero, Dual<Ball>(Ball(0.5))).by_s.is_finite());
}

TEST(DualArithmetics, HaveTheConstants) {
  EXPECT_EQ(from_rational<Dual<double>>(Rational(1, 4)).value, 0.25);
  EXPECT_TRUE(certainly_zero(pi<Dual<Ball>>().by_s));
  EXPECT_TRUE(from_rational<Dual<Ball>>(Rational(1, 3)).value.contains(Rational(1, 3)));
}

}  // namespace
}  // namespace radcert
