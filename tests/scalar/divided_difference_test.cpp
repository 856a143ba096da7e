// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/divided_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace radcert {
namespace {

static_assert(Field<DividedDifference<double>>);
static_assert(Field<DividedDifference<Rational>>);

using Exact = DividedDifference<Rational>;

/// The definition, from the values and slopes at both ends of a step that is not zero.
void expect_the_definition(const Exact& f, const Rational& at_p, const Rational& at_q,
                           const Rational& slope_p, const Rational& slope_q, const Rational& step) {
  const Rational first = (at_q - at_p) / step;
  EXPECT_EQ(f.at_p, at_p);
  EXPECT_EQ(f.at_q, at_q);
  EXPECT_EQ(f.slope_p, slope_p);
  EXPECT_EQ(f.slope_q, slope_q);
  EXPECT_EQ(f.first, first);
  EXPECT_EQ(f.second_p, (first - slope_p) / step);
  EXPECT_EQ(f.second_q, (slope_q - first) / step);
}

TEST(DividedDifference, OfPolynomialsIsItsDefinition) {
  for (const Rational& step : {Rational(1), Rational(-2, 7), Rational(1, 1000000)}) {
    const Rational p(3, 5);
    const Exact x = Exact::variable(p, 1, step);
    const Exact f = power(x, 5) - Rational(4) * x * x + (Rational(2) - x) * Exact(3);
    const auto value = [](const Rational& y) {
      return power(y, 5) - Rational(4) * y * y + Rational(3) * (Rational(2) - y);
    };
    const auto slope = [](const Rational& y) {
      return Rational(5) * power(y, 4) - Rational(8) * y - Rational(3);
    };
    const Rational q = p + step;
    expect_the_definition(f, value(p), value(q), slope(p), slope(q), step);
  }
}

TEST(DividedDifference, OfQuotientsIsItsDefinition) {
  for (const Rational& step : {Rational(3, 4), Rational(-1, 9)}) {
    const Rational p(2, 3);
    const Exact x = Exact::variable(p, 1, step);
    const Exact f = (x * x - Exact(7)) / (Rational(1) + x);
    const auto value = [](const Rational& y) { return (y * y - Rational(7)) / (Rational(1) + y); };
    const auto slope = [](const Rational& y) {
      const Rational w = Rational(1) + y;
      return (Rational(2) * y * w - (y * y - Rational(7))) / (w * w);
    };
    const Rational q = p + step;
    expect_the_definition(f, value(p), value(q), slope(p), slope(q), step);
  }
}

TEST(DividedDifference, AlongADirectionIsThatOfTheRestriction) {
  // f(s, t) = s^2 t at (1, 2) + l (3, -5), l from 0 to 1/4
  const Rational step(1, 4);
  const Exact f = power(Exact::variable(1, 3, step), 2) * Exact::variable(2, -5, step);
  const auto value = [](const Rational& l) {
    const Rational s = Rational(1) + Rational(3) * l;
    return s * s * (Rational(2) - Rational(5) * l);
  };
  const auto slope = [](const Rational& l) {
    const Rational s = Rational(1) + Rational(3) * l;
    return Rational(6) * s * (Rational(2) - Rational(5) * l) - Rational(5) * s * s;
  };
  expect_the_definition(f, value(0), value(step), slope(0), slope(step), step);
}

TEST(DividedDifference, AtStepZeroHasTheSlopeAndHalfTheSecondDerivative) {
  const Rational p(5, 3);
  const Exact x = Exact::variable(p, 1, 0);
  const Exact cube = power(x, 3);
  EXPECT_EQ(cube.first, Rational(3) * p * p);
  EXPECT_EQ(cube.second_p, Rational(3) * p);
  EXPECT_EQ(cube.second_q, Rational(3) * p);
  const Exact inverse = Exact(1) / x;
  EXPECT_EQ(inverse.first, Rational(-1) / (p * p));
  EXPECT_EQ(inverse.second_p, Rational(1) / (p * p * p));
  EXPECT_EQ(inverse.second_q, inverse.second_p);
}

TEST(DividedDifference, OfTheRootLosesNoDigits) {
  for (const double p : {1e-6, 0.3, 2.0})
    for (const double factor : {0.0, 1e-17, 1e-9, -1e-5, 1e-2, -0.4, 0.9, 30.0}) {
      const double step = p * factor;
      const DividedDifference<double> f = sqrt(DividedDifference<double>::variable(p, 1, step));
      const std::string where = std::to_string(p) + " " + std::to_string(factor);
      // sqrt[p,q] = 1/(a+b), sqrt[p,p,q] = -1/(2 a (a+b)^2), a and b the roots: no subtraction in these
      // either
      const long double a = std::sqrt(static_cast<long double>(p));
      const long double b = std::sqrt(static_cast<long double>(p) + step);
      EXPECT_NEAR(f.first * static_cast<double>(a + b), 1, 2e-15) << where;
      EXPECT_NEAR(f.second_p * static_cast<double>(-2 * a * (a + b) * (a + b)), 1, 4e-15) << where;
      EXPECT_NEAR(f.second_q * static_cast<double>(-2 * b * (a + b) * (a + b)), 1, 4e-15) << where;
    }
}

/// x^e [p,p,q] by the integral e (e-1) Int_0^1 (1-l) (p + l d)^(e-2) dl, Gauss's rule with 10 points on
/// graded parts.
long double bend_by_quadrature(long double e, long double p, long double d) {
  static const long double x[5] = {0.1488743389816312108848260L, 0.4333953941292471907992659L,
                                   0.6794095682990244062343274L, 0.8650633666889845107320967L,
                                   0.9739065285171717200779640L};
  static const long double w[5] = {0.2955242247147528701738930L, 0.2692667193099963550912269L,
                                   0.2190863625159820439955349L, 0.1494513491505805931457763L,
                                   0.0666713443086881375935688L};
  const auto over = [&](long double from, long double to) {
    long double sum = 0;
    for (int i = 0; i < 5; ++i)
      for (const int sign : {-1, 1}) {
        const long double l = (from + to) / 2 + sign * x[i] * (to - from) / 2;
        sum += w[i] * (1 - l) * std::pow(p + l * d, e - 2);
      }
    return sum * (to - from) / 2;
  };
  long double sum = 0;
  // Graded to both ends: the power may have its singularity at either.
  long double from = 0;
  for (int k = 60; k >= 1; --k) {
    const long double to = std::ldexp(0.5L, 1 - k);
    sum += over(from, to) + over(1 - to, 1 - from);
    from = to;
  }
  return e * (e - 1) * sum;
}

TEST(DividedDifference, OfAFractionalPowerLosesFewDigitsAtAnyStep) {
  for (const Rational& exponent : {Rational(3, 2), Rational(7, 3), Rational(5, 4), Rational(17, 3)}) {
    const Exponent<double> e(exponent);
    const auto el = from_rational<long double>(exponent);
    for (const double p : {0.7, 1e-3})
      // 0.49 and 0.51 lie on either side of the change from the series to the definition
      for (const double factor :
           {1e-300, 1e-12, -1e-6, 1e-3, -0.2, 0.49, 0.4999, 0.5001, 0.51, -0.49, -0.51, -0.9, 3.0, 200.0}) {
        const double step = p * factor;
        const DividedDifference<double> f = power(DividedDifference<double>::variable(p, 1, step), e);
        const long double q = static_cast<long double>(p) + step;
        const long double bend_p = bend_by_quadrature(el, p, step);
        const long double bend_q = bend_by_quadrature(el, q, -static_cast<long double>(step));
        const std::string where = exponent.to_text() + " " + std::to_string(p) + " " + std::to_string(factor);
        EXPECT_NEAR(f.second_p / static_cast<double>(bend_p), 1, 2e-14) << where;
        EXPECT_NEAR(f.second_q / static_cast<double>(bend_q), 1, 4e-14) << where;
        const long double first = el * std::pow(static_cast<long double>(p), el - 1) + step * bend_p;
        EXPECT_NEAR(f.first / static_cast<double>(first), 1, 4e-14) << where;
      }
  }
}

TEST(DividedDifference, OfAWholePowerIsThatOfTheProduct) {
  const Exponent<double> whole(Rational(3));
  const DividedDifference<double> x = DividedDifference<double>::variable(0.25, 1, 0.5);
  const DividedDifference<double> f = power(x, whole);
  const DividedDifference<double> product = x * x * x;
  EXPECT_EQ(f.second_p, product.second_p);
  EXPECT_EQ(f.second_q, product.second_q);
  EXPECT_EQ(f.first, product.first);
}

TEST(DividedDifference, OfAPowerOfAFunctionFollowsTheChainRule) {
  // (1 + x^2)^(3/2) = (1 + x^2) sqrt(1 + x^2)
  const DividedDifference<double> x = DividedDifference<double>::variable(0.6, 2, 0.05);
  const DividedDifference<double> inside = 1.0 + x * x;
  const DividedDifference<double> f = power(inside, Exponent<double>(Rational(3, 2)));
  const DividedDifference<double> g = inside * sqrt(inside);
  EXPECT_NEAR(f.at_q, g.at_q, 1e-15);
  EXPECT_NEAR(f.slope_p, g.slope_p, 1e-14);
  EXPECT_NEAR(f.slope_q, g.slope_q, 1e-14);
  EXPECT_NEAR(f.first, g.first, 1e-14);
  EXPECT_NEAR(f.second_p, g.second_p, 1e-13);
  EXPECT_NEAR(f.second_q, g.second_q, 1e-13);
}

TEST(DividedDifference, KeepsItsStepBesideConstants) {
  using D = DividedDifference<double>;
  const D x = D::variable(0.6, 2, 0.05);
  const Exponent<double> e(Rational(3, 2));
  const D truth = power(1.0 + 2.0 * x, e);
  for (const D& f : {power(D(1) + D(2) * x, e), power(x * D(2) + D(1), e), power((x + D(0.5)) / D(0.5), e)}) {
    EXPECT_NEAR(f.first, truth.first, 1e-14);
    EXPECT_NEAR(f.second_p, truth.second_p, 1e-14);
  }
  EXPECT_EQ((D(1) / x).step, x.step);
}

TEST(DividedDifference, OfAPowerFromItsSingularEnd) {
  // x^(3/2) [0,0,q] = q^(3/2) / q^2 and [0,q,q] = (3/2 q^(1/2) - q^(1/2)) / q
  const Exponent<double> e(Rational(3, 2));
  const double q = 0.04;
  const DividedDifference<double> f = power(DividedDifference<double>::variable(0, 1, q), e);
  EXPECT_NEAR(f.first, 0.2, 1e-15);
  EXPECT_NEAR(f.second_p, 5, 1e-13);
  EXPECT_NEAR(f.second_q, 2.5, 1e-13);
}

TEST(DividedDifference, AlongTheSingularLineOfAPowerIsZero) {
  for (const Rational& exponent : {Rational(3, 2), Rational(7, 3)}) {
    const DividedDifference<double> f =
        power(DividedDifference<double>::variable(0, 0, 1), Exponent<double>(exponent));
    EXPECT_EQ(f.first, 0);
    EXPECT_EQ(f.second_p, 0);
    EXPECT_EQ(f.second_q, 0);
  }
}

}  // namespace
}  // namespace radcert
