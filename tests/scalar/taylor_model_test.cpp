// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/taylor_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/dual.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

static_assert(Real<TaylorModel> && Enclosing<TaylorModel>);
static_assert(!std::is_convertible_v<double, TaylorModel> && !std::is_constructible_v<TaylorModel, bool>);

struct Function {
  const char* name;
  std::function<TaylorModel(const TaylorModel&, const TaylorModel&)> model;
  std::function<ComplexBall(const ComplexBall&, const ComplexBall&)> exact;
};

template <class F>
Function function(const char* name, F f) {
  return {name, [f](const TaylorModel& x, const TaylorModel& y) { return f(x, y); },
          [f](const ComplexBall& x, const ComplexBall& y) { return f(x, y); }};
}

std::vector<Function> functions() {
  return {function("sum", [](const auto& x, const auto& y) { return x + y; }),
          function("difference", [](const auto& x, const auto& y) { return x - y - x; }),
          function("product", [](const auto& x, const auto& y) { return x * y * x * x * y * y * x; }),
          function("constants",
                   []<class R>(const R& x, const R& y) {
                     return from_rational<R>(Rational(1, 3)) * x + pi<R>() * y - R(7);
                   }),
          function("quotient", [](const auto& x, const auto& y) { return x / y; }),
          function("x^-3", [](const auto& x, const auto& y) { return power(x, -3) + y; }),
          function("sqrt", [](const auto& x, const auto& y) { return sqrt(x * x + y); }),
          function("exp", [](const auto& x, const auto& y) { return exp(x * y); }),
          function("log", [](const auto& x, const auto& y) { return log(x + y); }),
          function("sin", [](const auto& x, const auto& y) { return sin(x + y); }),
          function("cos", [](const auto& x, const auto& y) { return cos(x - y); }),
          function("tan", [](const auto& x, const auto& y) { return tan(x) * y; }),
          function("atan", [](const auto& x, const auto& y) { return atan(x * y); }),
          function("pow", [](const auto& x, const auto& y) { return pow(x, y); }),
          function("pow by a whole number", []<class R>(const R& x, const R& y) { return pow(x, R(3)) - y; }),
          function("abs", [](const auto& x, const auto& y) { return abs(x) + y; }),
          function("max", [](const auto& x, const auto& y) { return max(x, y) - min(x, y); }),
          function("unit vector", []<class R>(const R& x, const R& y) {
            const R z = R(1) - x - y;
            return x * reciprocal(sqrt(x * x + y * y + z * z));
          })};
}

/// The polynomial's value.
ComplexBall polynomial(const TaylorModel& f, const ComplexBall& u, const ComplexBall& v) {
  ComplexBall sum;
  for (int i = 0; i <= TaylorModel::highest_degree; ++i)
    for (int j = 0; i + j <= TaylorModel::highest_degree; ++j) {
      const ComplexDouble c = f.coefficient(i, j);
      sum += ComplexBall(Ball(c.real), Ball(c.imag)) * power(u, i) * power(v, j);
    }
  return sum;
}

ComplexBall in_balls(const ComplexDouble& z) { return ComplexBall(Ball(z.real), Ball(z.imag)); }

/// A point of the closed disk, most often on its rim.
ComplexDouble of_disk(Draw& draw) {
  const double angle = std::numbers::pi / 4 * static_cast<double>(draw.below(8));
  const double size = draw.below(4) == 0 ? draw.unit() : 1 - 0x1p-50;
  return {size * std::cos(angle) * (1 - 0x1p-52), size * std::sin(angle) * (1 - 0x1p-52)};
}

TEST(TaylorModel, DiffersFromTheFunctionByNoMoreThanItsRemainder) {
  for (const Function& f : functions()) {
    Draw draw(41);
    int finite = 0;
    for (int trial = 0; trial < 250; ++trial) {
      const ComplexDouble x{3 * draw.unit() - 1, draw.below(2) == 0 ? 0 : draw.unit() - 0.5};
      const ComplexDouble y{3 * draw.unit() - 1, draw.below(2) == 0 ? 0 : draw.unit() - 0.5};
      const double radius_x = std::ldexp(draw.unit(), -static_cast<int>(draw.below(14)));
      const double radius_y =
          draw.below(4) == 0 ? 0 : std::ldexp(draw.unit(), -static_cast<int>(draw.below(14)));
      const TaylorModel model =
          f.model(TaylorModel::variable_u(x, radius_x), TaylorModel::variable_v(y, radius_y));
      if (!model.is_finite()) continue;
      ++finite;
      for (int sample = 0; sample < 4; ++sample) {
        const BallPrecision precision(200);
        const ComplexBall u = in_balls(of_disk(draw));
        const ComplexBall v = in_balls(of_disk(draw));
        const ComplexBall value = f.exact(in_balls(x) + ComplexBall(Ball(radius_x)) * u,
                                          in_balls(y) + ComplexBall(Ball(radius_y)) * v);
        ASSERT_TRUE(value.is_finite()) << f.name;
        const Ball rest = (value - polynomial(model, u, v)).magnitude();
        EXPECT_TRUE(certainly_at_most(rest, Ball(model.remainder())))
            << f.name << " at " << x.real << " " << x.imag << ", " << y.real << " " << y.imag << ": "
            << rest.to_text() << " > " << model.remainder();
        EXPECT_LE(value.magnitude().lower_double(), model.magnitude_bound()) << f.name;
      }
    }
    EXPECT_GT(finite, 50) << f.name;
  }
}

/// Whether the polynomial, which is a constant, differs from a number by no more than the remainder.
bool contains(const TaylorModel& model, const ComplexBall& number) {
  return certainly_at_most((number - in_balls(model.centre())).magnitude(), Ball(model.remainder()));
}

TEST(TaylorModel, OfAConstantHoldsItsRounding) {
  Draw draw(42);
  int judged = 0;
  for (const Function& f : functions())
    for (int trial = 0; trial < 60; ++trial) {
      const ComplexDouble x{0.25 + draw.unit(), trial % 2 == 0 ? 0 : draw.unit() - 0.5};
      const ComplexDouble y{1.5 + draw.unit(), trial % 2 == 0 ? 0 : draw.unit() - 0.5};
      const TaylorModel model = f.model(TaylorModel::variable_u(x, 0), TaylorModel::variable_v(y, 0));
      if (!model.is_finite()) continue;
      ++judged;
      const BallPrecision precision(200);
      EXPECT_TRUE(contains(model, f.exact(in_balls(x), in_balls(y))))
          << f.name << " " << x.real << " " << y.real;
    }
  EXPECT_GT(judged, 500);
  // One function alone, whose own rounding nothing else hides.
  for (int trial = 0; trial < 200; ++trial) {
    const ComplexDouble x{0.25 + draw.unit(), trial % 2 == 0 ? 0 : draw.unit() - 0.5};
    const TaylorModel model = TaylorModel::variable_u(x, 0);
    const BallPrecision precision(200);
    const ComplexBall at = in_balls(x);
    EXPECT_TRUE(contains(sqrt(model), sqrt(at)) && contains(reciprocal(model), reciprocal(at))) << x.real;
    EXPECT_TRUE(contains(exp(model), exp(at)) && contains(log(model), log(at))) << x.real << " " << x.imag;
    EXPECT_TRUE(contains(sin(model), sin(at)) && contains(atan(model), atan(at))) << x.real << " " << x.imag;
    const TaylorModel number(Ball(x.real));
    const ComplexBall there(Ball(x.real));
    EXPECT_TRUE(contains(sqrt(number), sqrt(there)) && contains(reciprocal(number), reciprocal(there)));
    EXPECT_TRUE(contains(exp(number), exp(there)) && contains(log(number), log(there)));
  }
}

TEST(TaylorModel, TakesAWideBallWhole) {
  // All that is not known stands in the remainder: a function sees its ends.
  for (const double middle : {1.0, 3.0})
    for (const double part : {0.1, 0.5}) {
      const Ball ball = hull(Ball(middle * (1 - part)), Ball(middle * (1 + 2 * part)));
      const TaylorModel x(ball);
      for (const Ball& end : {ball.lower(), ball.upper()}) {
        const ComplexBall at(end);
        EXPECT_TRUE(contains(x, at));
        EXPECT_LE(end.upper_double(), x.magnitude_bound());
        EXPECT_TRUE(contains(x * x, at * at)) << middle << " " << part;
        EXPECT_TRUE(contains(x * TaylorModel(Ball(7)) - x, at * ComplexBall(6))) << middle << " " << part;
        const auto holds = [&](const TaylorModel& model, const ComplexBall& number) {
          EXPECT_TRUE(!model.is_finite() || contains(model, number)) << middle << " " << part;
        };
        holds(sqrt(x), sqrt(at));
        holds(reciprocal(x), reciprocal(at));
        holds(log(x), log(at));
        holds(exp(x), exp(at));
        holds(sin(x), sin(at));
        holds(atan(x), atan(at));
        const TaylorModel both = hull(x, TaylorModel(Ball(-5)));
        EXPECT_TRUE(contains(both, at) && contains(both, ComplexBall(Ball(-5))));
      }
    }
  const TaylorModel wide =
      hull(TaylorModel(widened(Ball(0), Ball(1))), TaylorModel(widened(Ball(0), Ball(2))));
  EXPECT_GE(wide.remainder(), 2);
  EXPECT_FALSE(certainly_positive(TaylorModel(widened(Ball(1), Ball(2)))));
}

TEST(TaylorModel, IsOfTheFifthOrder) {
  for (const Function& f : functions()) {
    const auto remainder = [&](double radius) {
      const TaylorModel value = f.model(TaylorModel::variable_u({0.75, 0.125}, radius),
                                        TaylorModel::variable_v({1.25, -0.25}, radius));
      EXPECT_TRUE(value.is_finite()) << f.name << ": " << value.failure();
      return value.remainder();
    };
    // From 2^-5 to 2^-7 by about 4^5, or down to rounding.
    EXPECT_LT(remainder(0x1p-7), std::max(remainder(0x1p-5) / 600, 1e-11)) << f.name;
    EXPECT_LT(remainder(0x1p-7), 1e-6) << f.name;
  }
}

TEST(TaylorModel, FailsByNameWhereItCannotShowThatAFunctionIsAnalytic) {
  const auto u = [](double centre, double radius) { return TaylorModel::variable_u({centre, 0}, radius); };
  EXPECT_EQ(reciprocal(u(1, 1)).failure(), "division by a model that may vanish");
  EXPECT_TRUE(reciprocal(u(1, 0.99)).is_finite());
  EXPECT_EQ(sqrt(u(1, 1.5)).failure(), "sqrt of a model that touches its cut");
  EXPECT_EQ(sqrt(u(-1, 0.5)).failure(), "sqrt of a model that touches its cut");
  EXPECT_EQ(sqrt(TaylorModel::variable_u({-1, 0.5}, 0.5)).failure(), "sqrt of a model that touches its cut");
  EXPECT_TRUE(sqrt(TaylorModel::variable_u({-1, 0.5}, 0.49)).is_finite());
  EXPECT_EQ(log(u(0, 0.5)).failure(), "log of a model that touches its cut");
  EXPECT_FALSE(log(u(-1, 0.5)).is_finite());
  EXPECT_FALSE(pow(u(-1, 0.5), TaylorModel(0.5)).is_finite());
  EXPECT_TRUE(pow(u(-1, 0.5), TaylorModel(2)).is_finite());
  EXPECT_FALSE(atan(TaylorModel::variable_u({0, 0.5}, 0.5)).is_finite());
  EXPECT_FALSE(atan(TaylorModel::variable_u({0, 2}, 0.25)).is_finite());
  EXPECT_TRUE(atan(TaylorModel::variable_u({0.5, 2}, 0.25)).is_finite());
  EXPECT_FALSE(tan(u(1.5, 0.25)).is_finite());
  EXPECT_EQ(abs(u(0.5, 0.5)).failure(), "abs where the sign changes is not analytic");
  EXPECT_FALSE(max(u(0, 1), TaylorModel(0)).is_finite());
  EXPECT_FALSE((u(1e120, 1) * u(1e120, 1)).is_finite());
  EXPECT_FALSE(reciprocal(u(1e-100, 0)).is_finite());
  EXPECT_FALSE(exp(u(1000, 1)).is_finite());
  const TaylorModel failed = sqrt(u(-1, 0.5));
  EXPECT_EQ((failed * TaylorModel(0)).failure(), failed.failure());
  EXPECT_EQ((log(u(0, 1)) + failed).failure(), "log of a model that touches its cut");
  EXPECT_FALSE(std::isfinite(failed.magnitude_bound()));
  EXPECT_THROW(static_cast<void>(failed.deviation()), ContractViolation);
  EXPECT_THROW(static_cast<void>(TaylorModel::variable_u({0, 0}, -1)), ContractViolation);
  EXPECT_EQ(TaylorModel(Ball(HUGE_VAL)).failure(), Ball(HUGE_VAL).failure());
}

TEST(TaylorModel, KeepsConstantsAndZeroExact) {
  EXPECT_TRUE(certainly_zero(TaylorModel()));
  EXPECT_TRUE(certainly_zero(TaylorModel(0) * TaylorModel::variable_u({1, 0}, 1)));
  EXPECT_EQ((TaylorModel(3) - TaylorModel(1)).remainder(), 0);
  EXPECT_EQ((TaylorModel(2.5) - TaylorModel(1)).remainder(), 0);
  EXPECT_GT((TaylorModel(1e-30) + TaylorModel(1)).remainder(), 0.9e-30);
  EXPECT_GT(TaylorModel(Rational(1, 3)).remainder(), 0);
  EXPECT_LT(TaylorModel(Rational(1, 3)).remainder(), 1e-16);
  EXPECT_EQ(TaylorModel(Rational(1, 4)).remainder(), 0);
}

TEST(TaylorModel, KeepsConstantsReal) {
  Draw draw(81);
  for (const Function& f : functions())
    for (int k = 0; k < 50; ++k) {
      const TaylorModel x(widened(Ball(0.1 + draw.unit()), Ball(k % 2 == 0 ? 0 : 1e-3)));
      const TaylorModel y(Ball(Rational(static_cast<long>(draw.below(100)) + 1, 77)));
      for (const TaylorModel& value : {f.model(x, y), f.model(y, x), f.model(-x, y)})
        if (value.is_finite()) {
          EXPECT_EQ(value.centre().imag, 0) << f.name;
        }
    }
}

TEST(TaylorModel, CarriesDividedDifferencesOfPowers) {
  // phi[a,a,b] for phi = x^(5/2), a fixed, the step a model around zero and away from it.
  const Exponent<TaylorModel> exponent(Rational(5, 2));
  using D = DividedDifference<TaylorModel>;
  for (const double centre : {0.0, 0.25}) {
    const TaylorModel step = TaylorModel::variable_u({centre, 0}, 0.0625);
    const D model = power(D::variable(TaylorModel(1), TaylorModel(1), step), exponent);
    ASSERT_TRUE(model.second_p.is_finite() && model.first.is_finite());
    for (const double u : {-1.0, -0.5, 0.5, 1.0}) {
      const BallPrecision precision(200);
      const Ball d = Ball(centre) + Ball(0.0625) * Ball(u);
      const Ball e(Rational(5, 2));
      const Ball first = (pow(1 + d, e) - 1) / d;
      const auto within = [&](const TaylorModel& found, const Ball& exact) {
        const ComplexBall rest = ComplexBall(exact) - polynomial(found, ComplexBall(Ball(u)), 0);
        EXPECT_TRUE(certainly_at_most(rest.magnitude(), Ball(found.remainder()))) << rest.to_text();
      };
      within(model.first, first);
      within(model.second_p, (first - e) / d);
    }
  }
}

TEST(TaylorModel, ContainsBothInAHull) {
  const TaylorModel a = exp(TaylorModel::variable_u({0.5, 0}, 0.25));
  const TaylorModel b = sin(TaylorModel::variable_v({0.25, 0.5}, 0.25));
  const TaylorModel both = hull(a, b);
  for (const TaylorModel& one : {a, b}) {
    double difference = 0;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j) {
        const ComplexDouble c = one.coefficient(i, j);
        const ComplexDouble d = both.coefficient(i, j);
        difference += std::hypot(c.real - d.real, c.imag - d.imag);
      }
    EXPECT_GE(both.remainder(), (difference + one.remainder()) * (1 - 1e-12));
  }
}

}  // namespace
}  // namespace radcert
