// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/taylor_series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/scalar/ball.h"

namespace radcert {
namespace {

constexpr int degree = 8;
using Series = TaylorSeries<degree>;

void expect_holds(const BoundedDouble& found, const Ball& exact, double relative, std::size_t k) {
  const Ball difference = abs(Ball(found.value()) - exact);
  EXPECT_LE(difference.lower().to_double(), found.error()) << k;
  EXPECT_LE(found.error(), relative) << k;
}

const Series argument = Series::linear(BoundedDouble(1), BoundedDouble::exactly(0.25));

TEST(TaylorSeries, HasTheCoefficientsOfElementaryFunctions) {
  const Series root = sqrt(argument);
  const Series logarithm = log(argument);
  const Series inverse = Series(BoundedDouble(1)) / argument;
  Rational of_root = 1;
  Rational of_inverse = 1;
  for (std::size_t k = 0; k <= degree; ++k) {
    const long n = static_cast<long>(k);
    expect_holds(root[k], Ball(of_root), 1e-13, k);
    expect_holds(inverse[k], Ball(of_inverse), 1e-13, k);
    if (k > 0) expect_holds(logarithm[k], Ball(-of_inverse / n), 1e-13, k);
    // binomial(1/2, k+1) = binomial(1/2, k) (1/2 - k) / (k + 1)
    of_root = of_root * (Rational(1, 2) - n) / (n + 1) / 4;
    of_inverse = of_inverse * Rational(-1, 4);
  }
  EXPECT_EQ(logarithm[0].value(), 0);
}

TEST(TaylorSeries, AreInverseToEachOther) {
  const Series root = sqrt(argument);
  const Series square = root * root;
  const Series back = (argument * root) / root;
  for (std::size_t k = 0; k <= degree; ++k) {
    const Ball exact = k == 0 ? Ball(1) : (k == 1 ? Ball(Rational(1, 4)) : Ball(0));
    expect_holds(square[k], exact, 1e-13, k);
    expect_holds(back[k], exact, 1e-13, k);
  }
}

TEST(TaylorSeries, OfTheArcTangentAreThoseOfItsDerivative) {
  // (1 + a^2) (atan a)' = a'
  const Series angle = atan(argument);
  const Series slope = Series(BoundedDouble(1)) + argument * argument;
  for (std::size_t k = 0; k < degree; ++k) {
    BoundedDouble sum(0);
    for (std::size_t j = 0; j <= k; ++j)
      sum = sum + BoundedDouble(static_cast<int>(j) + 1) * angle[j + 1] * slope[k - j];
    expect_holds(sum, k == 0 ? Ball(Rational(1, 4)) : Ball(0), 1e-13, k);
  }
}

TEST(TaylorSeries, EncloseAllPointsOfTheInterval) {
  // At y = +-1 and between, the coefficients are those of the series about there.
  const auto at = [](double y) {
    return Series::linear(BoundedDouble::exactly(1 + y / 4), BoundedDouble::exactly(0.25));
  };
  const auto f = [](const Series& x) { return log(x * x * x) * sqrt(x) + atan(x) / x; };
  const Series polynomial = argument * argument * argument;
  const Series wide = polynomial.everywhere();
  const Series everywhere = f(argument.everywhere());
  for (const double y : {-1.0, -0.5, 0.0, 0.25, 1.0}) {
    const Series exact = at(y) * at(y) * at(y);
    const Series there = f(at(y));
    for (std::size_t k = 0; k <= degree; ++k) {
      EXPECT_LE(std::abs(exact[k].value() - wide[k].value()), wide[k].error() + 1e-15) << y << " " << k;
      EXPECT_LE(std::abs(there[k].value() - everywhere[k].value()), everywhere[k].error() + 1e-13) << y << k;
    }
  }
  // And not by far more: the cube is largest at y = 1.
  EXPECT_NEAR(wide[0].value() + wide[0].error(), 1.25 * 1.25 * 1.25, 1e-12);
  EXPECT_EQ(wide[4].error(), 0);
}

TEST(TaylorSeries, SayNothingWhereAFunctionHasNoValue) {
  const Series wide = Series::linear(BoundedDouble(0), BoundedDouble(1)).everywhere();
  EXPECT_FALSE(std::isfinite(log(wide)[0].error()));
  EXPECT_FALSE(std::isfinite(sqrt(wide)[1].error()));
  EXPECT_FALSE(std::isfinite((Series(BoundedDouble(1)) / wide)[0].error()));
}

TEST(TaylorSeries, CarryTheErrorsOfTheirArguments) {
  // Each coefficient of the product moves with those of the factors: ends of their intervals are within.
  const Series a = Series::linear(BoundedDouble(3, 0.5), BoundedDouble(-2, 0.25));
  const Series b = Series::linear(BoundedDouble(-1, 0.125), BoundedDouble(4, 1));
  const Series product = a * b;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-1.0, 1.0})
      for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0}) {
          const double a0 = 3 + 0.5 * s;
          const double a1 = -2 + 0.25 * t;
          const double b0 = -1 + 0.125 * u;
          const double b1 = 4 + v;
          EXPECT_LE(std::abs(a0 * b0 - product[0].value()), product[0].error());
          EXPECT_LE(std::abs(a0 * b1 + a1 * b0 - product[1].value()), product[1].error());
          EXPECT_LE(std::abs(a1 * b1 - product[2].value()), product[2].error());
        }
  EXPECT_NEAR(product[0].error(), 3 * 0.125 + 0.5 * 1.125, 1e-12);
}

}  // namespace
}  // namespace radcert
