// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/complex_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "radcert/scalar/dual.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

static_assert(Real<ComplexBall> && Enclosing<ComplexBall>);
static_assert(std::is_nothrow_move_constructible_v<ComplexBall>);
static_assert(!std::is_convertible_v<double, ComplexBall> && !std::is_constructible_v<ComplexBall, bool>);

ComplexBall box(double x0, double x1, double y0, double y1) {
  return ComplexBall(hull(Ball(x0), Ball(x1)), hull(Ball(y0), Ball(y1)));
}

ComplexBall point(double x, double y) { return ComplexBall(Ball(x), Ball(y)); }

struct Function {
  const char* name;
  std::function<ComplexBall(const ComplexBall&)> value;
  std::function<Ball(const Ball&)> real;
};

template <class F>
Function function(const char* name, F f) {
  return {name, [f](const ComplexBall& z) { return f(z); }, [f](const Ball& x) { return f(x); }};
}

std::vector<Function> functions() {
  return {function("reciprocal", [](const auto& x) { return reciprocal(x); }),
          function("square", [](const auto& x) { return x * x; }),
          function("x^-3", [](const auto& x) { return power(x, -3); }),
          function("x^5", [](const auto& x) { return power(x, 5); }),
          function("sqrt", [](const auto& x) { return sqrt(x); }),
          function("exp", [](const auto& x) { return exp(x); }),
          function("log", [](const auto& x) { return log(x); }),
          function("sin", [](const auto& x) { return sin(x); }),
          function("cos", [](const auto& x) { return cos(x); }),
          function("tan", [](const auto& x) { return tan(x); }),
          function("atan", [](const auto& x) { return atan(x); }),
          function("abs", [](const auto& x) { return abs(x); }),
          function("x^(7/3)", []<class R>(const R& x) { return pow(x, R(7) / R(3)); })};
}

TEST(ComplexBall, ContainsTheValuesAtItsPoints) {
  Draw draw(31);
  for (const Function& f : functions()) {
    int finite = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const BallPrecision precision(draw.below(2) == 0 ? 53 : 128);
      const double x = 6 * draw.unit() - 3;
      const double y = draw.below(3) == 0 ? 0 : 4 * draw.unit() - 2;
      const double width = std::ldexp(draw.unit(), -static_cast<int>(draw.below(12)));
      const double height = std::ldexp(draw.unit(), -static_cast<int>(draw.below(12)));
      const ComplexBall value = f.value(box(x, x + width, y, y + height));
      if (!value.is_finite()) continue;
      ++finite;
      for (const double s : {0.0, 0.5, 1.0, draw.unit()})
        for (const double t : {0.0, 1.0, draw.unit()}) {
          const BallPrecision exactly(300);
          const ComplexBall inside =
              f.value(point(std::min(x + s * width, x + width), std::min(y + t * height, y + height)));
          EXPECT_TRUE(overlaps(value, inside))
              << f.name << " at " << x << " " << y << ": " << value.to_text();
        }
    }
    EXPECT_GT(finite, 60) << f.name;
  }
}

TEST(ComplexBall, ContinuesTheRealFunctions) {
  Draw draw(32);
  for (const Function& f : functions())
    for (int trial = 0; trial < 200; ++trial) {
      const double x = 6 * draw.unit() - 3;
      const ComplexBall value = f.value(point(x, 0));
      const Ball real = f.real(Ball(x));
      if (!value.is_finite()) continue;
      EXPECT_TRUE(real.is_finite()) << f.name << " at " << x;
      EXPECT_TRUE(overlaps(value.real(), real)) << f.name << " at " << x;
      EXPECT_TRUE(value.imag().contains_zero());
      EXPECT_LT(value.imag().radius(), 1e-30);
    }
}

TEST(ComplexBall, HasTheIdentitiesOfItsFunctions) {
  Draw draw(33);
  for (int trial = 0; trial < 300; ++trial) {
    const ComplexBall z = point(0.1 + 2 * draw.unit(), 4 * draw.unit() - 2);
    const ComplexBall i(Ball(0), Ball(1));
    const auto same = [&](const ComplexBall& a, const ComplexBall& b) {
      EXPECT_TRUE(overlaps(a, b)) << z.to_text() << ": " << a.to_text() << ", " << b.to_text();
      EXPECT_LT((a - b).magnitude_bound(), 1e-28);
    };
    same(power(sqrt(z), 2), z);
    same(exp(log(z)), z);
    same(exp(i * z), cos(z) + i * sin(z));
    same(tan(z), sin(z) / cos(z));
    same(tan(atan(z)), z);
    same(pow(z, ComplexBall(Rational(1, 2))), sqrt(z));
    same(power(z, 3) * power(z, -3), 1);
    same(z * reciprocal(z), 1);
    same(ComplexBall(power(z.magnitude(), 2)), z * ComplexBall(z.real(), -z.imag()));
    EXPECT_GE(z.magnitude_bound(), z.magnitude().lower_double());
  }
}

TEST(ComplexBall, FailsByNameWhereAFunctionIsNotAnalytic) {
  const ComplexBall around_zero = box(-1, 1, -1, 1);
  const ComplexBall on_the_cut = box(-2, -1, -0.5, 0);
  const ComplexBall beside_the_cut = box(-2, -1, 0.25, 1);
  EXPECT_EQ((ComplexBall(1) / around_zero).failure(), "division by a complex ball that contains zero");
  EXPECT_EQ(sqrt(around_zero).failure(), "sqrt of a complex ball that touches its cut");
  EXPECT_EQ(sqrt(on_the_cut).failure(), "sqrt of a complex ball that touches its cut");
  EXPECT_EQ(sqrt(ComplexBall(0)).failure(), "sqrt of a complex ball that touches its cut");
  EXPECT_EQ(log(on_the_cut).failure(), "log of a complex ball that touches its cut");
  EXPECT_EQ(pow(on_the_cut, ComplexBall(Rational(1, 3))).failure(),
            "pow of a complex ball that touches its cut");
  EXPECT_EQ(atan(box(-0.5, 0.5, 0.5, 1)).failure(), "atan of a complex ball that touches its cut");
  EXPECT_EQ(abs(box(-1, 1, 0, 0)).failure(), "abs where the sign changes is not analytic");
  EXPECT_EQ(min(around_zero, ComplexBall(0)).failure(), "min where the order changes is not analytic");
  EXPECT_FALSE(max(around_zero, ComplexBall(0)).is_finite());
  EXPECT_FALSE(select_less(around_zero, 0, 1, 2).is_finite());
  EXPECT_FALSE(tan(box(1, 2, -0.1, 0.1)).is_finite());
  EXPECT_TRUE(sqrt(beside_the_cut).is_finite());
  EXPECT_TRUE(atan(box(0.25, 0.5, 0.5, 2)).is_finite());
  EXPECT_TRUE(power(around_zero, 3).is_finite());
  EXPECT_TRUE(overlaps(abs(box(-2, -1, 0, 1)), -box(-2, -1, 0, 1)));
  // The first failure stays, through zero too.
  const ComplexBall failed = sqrt(around_zero);
  EXPECT_EQ((failed * ComplexBall(0)).failure(), failed.failure());
  EXPECT_EQ((log(on_the_cut) + failed).failure(), "log of a complex ball that touches its cut");
  EXPECT_EQ(failed.real().failure(), failed.failure());
  EXPECT_EQ(power(failed, 0).failure(), failed.failure());
  EXPECT_EQ(ComplexBall(Ball(HUGE_VAL)).failure(), Ball(HUGE_VAL).failure());
}

TEST(ComplexBall, CarriesDerivativesAndDividedDifferences) {
  const BallPrecision precision(200);
  const auto f = []<class T>(const T& x) { return sqrt(x * x + T(1)) / x; };
  const ComplexBall z = point(0.75, 0.5);
  const ComplexBall d = point(0.125, -0.25);
  const Dual<ComplexBall> dual = f(Dual<ComplexBall>(z, 1, 0));
  // D sqrt(x^2 + 1)/x = -1 / (x^2 sqrt(x^2 + 1))
  EXPECT_TRUE(overlaps(dual.by_s, -reciprocal(z * z * sqrt(z * z + 1))));
  using D = DividedDifference<ComplexBall>;
  const D difference = f(D::variable(z, 1, d));
  EXPECT_TRUE(overlaps(difference.first, (f(z + d) - f(z)) / d));
  EXPECT_TRUE(overlaps(difference.second_p, ((f(z + d) - f(z)) / d - dual.by_s) / d));
  const Exponent<ComplexBall> exponent(Rational(5, 2));
  const D raised = power(D::variable(z, 1, d), exponent);
  const ComplexBall e = ComplexBall(Rational(5, 2));
  EXPECT_TRUE(overlaps(raised.first, (pow(z + d, e) - pow(z, e)) / d));
  EXPECT_TRUE(overlaps(raised.second_p, (raised.first - e * pow(z, e - 1)) / d));
  // A step that contains zero, and one that is zero.
  const D around = power(D::variable(z, 1, box(-0.0625, 0.0625, -0.0625, 0.0625)), exponent);
  EXPECT_TRUE(around.second_p.contains(e * (e - 1) / 2 * pow(z, e - 2)));
  EXPECT_LT(around.second_p.magnitude_bound(), 10);
}

}  // namespace
}  // namespace radcert
