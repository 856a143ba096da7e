// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/edge_exponents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/edge/edge_symbol_patch.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/functions/beta_function.h"

namespace radcert {
namespace {

using Complex = std::complex<double>;

Ball radians(const Rational& degrees) { return Ball::pi() * Ball(degrees / Rational(180)); }

ComplexBall exponent(const Rational& real, const Rational& imag = 0) { return {Ball(real), Ball(imag)}; }

// k(b) sin(pi b)/pi by Gauss's series, in complex doubles.
Complex entire_in_double(double angle, const Complex& b) {
  const double x = std::pow(std::cos(angle / 2), 2);
  const Complex beta = b * (b + 1.0);
  Complex term = 1;
  Complex sum = 0;
  for (int n = 0; n < 4000; ++n) {
    sum += term;
    const double m = n;
    term *= (m * (m + 1) - beta) / ((m + 1) * (m + 2)) * x;
  }
  return x * beta * sum;
}

TEST(EdgeSymbol, AtRightAnglesIsABetaFunction) {
  const EdgeSymbol symbol(radians(90));
  for (const Rational& b : {Rational(-19, 10), Rational(-1, 2), Rational(1, 7), Rational(99, 100)}) {
    const Ball k = symbol(exponent(b)).real();
    const Ball beta = beta_function(Ball(1 + b / 2), Ball((1 - b) / 2)) / Ball(4);
    EXPECT_TRUE(overlaps(k, beta)) << b.to_text();
    EXPECT_LT((k - beta).upper_double(), 1e-30) << b.to_text();
  }
}

TEST(EdgeSymbol, IsTheSameForOppositeExponentsAndSeesConstantsUnderTheAngle) {
  for (const long degrees : {20, 60, 89, 120, 179}) {
    const EdgeSymbol symbol(radians(degrees));
    for (const Rational& b : {Rational(1, 3), Rational(9, 10), Rational(11, 4)})
      EXPECT_TRUE(overlaps(symbol(exponent(b, Rational(1, 5))), symbol(exponent(-1 - b, Rational(-1, 5)))))
          << degrees << " " << b.to_text();
    // Of constants a point sees (1 + cos w)/2, as b tends to 0.
    const Ball near_zero = symbol(exponent(Rational(1, 1000000000))).real();
    EXPECT_NEAR(near_zero.to_double(), (1 + std::cos(degrees * std::numbers::pi / 180)) / 2, 1e-8);
  }
}

// Wide operands, thin ones at the precision of the search, and slopes by differences.
TEST(EdgeSymbol, ContainsItsValuesAndSlopes) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const long degrees : {30, 75, 90, 150})
    for (int i = 0; i < 8; ++i) {
      const BallPrecision precision(80);
      const EdgeSymbol symbol(radians(degrees));
      const ComplexBall middle(Ball(2 + 2 * unit(random)), Ball(2 * unit(random)));
      const double width = i % 2 == 0 ? 0.25 : 1e-6;
      const ComplexBall wide(widened(middle.real(), Ball(width)), widened(middle.imag(), Ball(width)));
      const EdgeSymbolPatch patch(symbol, wide);
      const SymbolValue over = symbol.entire(wide);
      const SymbolValue by_patch = patch.entire(wide);
      for (int j = 0; j < 10; ++j) {
        const ComplexBall b((middle.real() + Ball(width * unit(random))).midpoint(),
                            (middle.imag() + Ball(width * unit(random))).midpoint());
        const BallPrecision high(300);
        const EdgeSymbol sharp(radians(degrees));
        const SymbolValue exact = sharp.entire(b);
        const ComplexBall step = exponent(Rational(1) / power(Rational(10), 20));
        const ComplexBall difference =
            (sharp.entire(b + step).value - sharp.entire(b - step).value) / (ComplexBall(2) * step);
        EXPECT_LT((difference - exact.slope).magnitude_bound(), 1e-30);
        EXPECT_TRUE(over.value.contains(exact.value));
        EXPECT_TRUE(over.slope.contains(exact.slope));
        EXPECT_TRUE(by_patch.value.contains(exact.value));
        EXPECT_TRUE(by_patch.slope.contains(exact.slope));
        const SymbolValue of_patch = patch.entire(b);
        EXPECT_TRUE(overlaps(of_patch.value, exact.value));
        EXPECT_TRUE(overlaps(of_patch.slope, exact.slope));
        EXPECT_LT((of_patch.value - exact.value).magnitude_bound(), 1e-6);
        EXPECT_LT((of_patch.slope - exact.slope).magnitude_bound(), 1e-4);
      }
    }
}

// The terms that are left out, where few are taken: at 6 to 30 bits the tail is no smaller than rounding.
TEST(EdgeSymbol, CountsWhatItsSeriesLeavesOut) {
  for (const long bits : {6, 10, 20, 30})
    for (const Rational& b : {Rational(1, 2), Rational(5, 2), Rational(7, 3)}) {
      SymbolValue coarse;
      {
        const BallPrecision precision(bits);
        coarse = EdgeSymbol(Ball(1)).entire(exponent(b));
      }
      const BallPrecision precision(300);
      const SymbolValue exact = EdgeSymbol(Ball(1)).entire(exponent(b));
      EXPECT_TRUE(coarse.value.contains(exact.value)) << bits << " " << b.to_text();
      EXPECT_TRUE(coarse.slope.contains(exact.slope)) << bits << " " << b.to_text();
    }
}

// The Taylor coefficients beyond those kept are small against rounding, but for that at 600 bits.
TEST(EdgeSymbolPatch, CountsTheDegreesThatItLeavesOut) {
  const BallPrecision precision(600);
  const EdgeSymbol symbol(radians(75));
  const EdgeSymbolPatch patch(
      symbol, exponent(Rational(3, 2)) + ComplexBall(hull(Ball(-1), Ball(1)), hull(Ball(-1), Ball(1))));
  for (const Rational& b : {Rational(1, 2), Rational(2), Rational(5, 2)}) {
    const SymbolValue of_patch = patch.entire(exponent(b));
    const SymbolValue exact = symbol.entire(exponent(b));
    EXPECT_TRUE(overlaps(of_patch.value, exact.value)) << b.to_text();
    EXPECT_TRUE(overlaps(of_patch.slope, exact.slope)) << b.to_text();
  }
}

TEST(EdgeSymbol, AsksForAnAngle) {
  for (const Ball& angle : {Ball(0), Ball(-1), Ball(4), Ball::pi()})
    EXPECT_THROW(EdgeSymbol{angle}, ContractViolation);
  // Beside the set of a patch nothing is told.
  const EdgeSymbolPatch patch(EdgeSymbol(Ball(1)), ComplexBall(hull(Ball(1), Ball(2)), Ball(0)));
  EXPECT_FALSE(patch.entire(ComplexBall(3)).value.is_finite());
}

// How often R pi x b (b+1) F - s sin(pi b) turns about 0 along a rectangle, in doubles: its zeros inside.
int turns(double angle, double scale, int sign, double left, double right, double height) {
  const auto h = [&](const Complex& b) {
    return scale * std::numbers::pi * entire_in_double(angle, b) -
           static_cast<double>(sign) * std::sin(std::numbers::pi * b);
  };
  const std::vector<Complex> corners{{left, -height}, {right, -height}, {right, height}, {left, height}};
  double turned = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    constexpr int steps = 1500;
    Complex before = h(corners[i]);
    for (int k = 1; k <= steps; ++k) {
      const Complex at = corners[i] + (corners[(i + 1) % 4] - corners[i]) * (static_cast<double>(k) / steps);
      const Complex now = h(at);
      turned += std::arg(now / before);
      before = now;
    }
  }
  return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
}

TEST(EdgeExponents, AreAsManyAsTheArgumentPrincipleCounts) {
  struct Example {
    long degrees;
    Rational rho;
    Rational up_to;
  };
  for (const Example& e : {Example{90, Rational(1, 2), Rational(27, 5)},
                           {90, Rational(9, 10), Rational(23, 5)},
                           {60, Rational(1, 2), Rational(9, 2)},
                           {75, Rational(9, 10), Rational(5)},
                           {150, Rational(4, 5), Rational(7, 2)},
                           {40, Rational(1, 10), Rational(33, 10)}}) {
    const Edge edge = edge_of_degrees(e.degrees, e.rho, e.rho);
    const auto found = edge_exponents(edge, e.up_to, 15);
    ASSERT_TRUE(found) << found.reason();
    for (const int sign : {1, -1}) {
      int count = 0;
      for (const EdgeExponent& exponent : *found) {
        if (exponent.symmetric != (sign > 0)) continue;
        count += exponent.value.is_real() ? 1 : 2;
        const Complex b(exponent.value.real().to_double(), exponent.value.imag().to_double());
        const double angle = static_cast<double>(e.degrees) * std::numbers::pi / 180;
        const Complex k = std::numbers::pi * entire_in_double(angle, b) / std::sin(std::numbers::pi * b);
        EXPECT_LT(std::abs(e.rho.to_double() * k - static_cast<double>(sign)), 1e-9) << e.degrees;
      }
      // At right angles H vanishes at 2, 4, ... for either sign, and these are no exponents.
      const int whole = e.degrees == 90 ? static_cast<int>(e.up_to.to_double()) / 2 : 0;
      EXPECT_EQ(count + whole, turns(static_cast<double>(e.degrees) * std::numbers::pi / 180,
                                     e.rho.to_double(), sign, 0.05, e.up_to.to_double(), 4))
          << e.degrees << " " << sign;
    }
  }
}

TEST(EdgeExponents, BeginWithTheSmallest) {
  for (const long degrees : {30, 60, 90, 120, 150})
    for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(9, 10)}) {
      const Edge edge = edge_of_degrees(degrees, rho, Rational(1, 3));
      const auto smallest = smallest_edge_exponent(edge, Rational(1) / power(Rational(10), 30));
      ASSERT_TRUE(smallest) << smallest.reason();
      EXPECT_LE(smallest->radius(), 1e-30);
      const auto all = edge_exponents(edge, 2, 25);
      ASSERT_TRUE(all) << all.reason();
      EXPECT_TRUE(overlaps(all->front().value.real(), *smallest));
      EXPECT_TRUE(all->front().symmetric && all->front().value.is_real());
    }
}

TEST(EdgeExponents, DependOnTheProductOfTheReflectivities) {
  const Rational radius = Rational(1) / power(Rational(10), 20);
  const auto one = smallest_edge_exponent(edge_of_degrees(70, Rational(1, 2), Rational(1, 2)), radius);
  const auto other = smallest_edge_exponent(edge_of_degrees(70, Rational(3, 4), Rational(1, 3)), radius);
  EXPECT_TRUE(overlaps(*one, *other));
}

// R k(4) = 1 for R = 3/4 at a right angle, where k(4) = 4/3: H has a double zero there.
TEST(EdgeExponents, AreNotToldWhereOneIsWholeAtARightAngle) {
  const Edge edge = edge_of_degrees(90, Rational(3, 4), Rational(3, 4));
  EXPECT_FALSE(edge_exponents(edge, 5, 10));
  EXPECT_TRUE(edge_exponents(edge, 3, 10));
}

TEST(EdgeExponents, AskForTheirArguments) {
  EXPECT_THROW(static_cast<void>(edge_of_degrees(180, Rational(1, 2), Rational(1, 2))), ContractViolation);
  EXPECT_THROW(static_cast<void>(edge_exponents(edge_of_degrees(90, 0, Rational(1, 2)), 1, 5)),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(edge_exponents(edge_of_degrees(90, Rational(1, 2), 1), 1, 5)),
               ContractViolation);
}

TEST(EdgeExponents, AreRefusedWhereAnAngleIsNotToldFromAStraightOne) {
  for (const int nines : {30, 40, 60}) {
    const Edge edge = edge_of_degrees(Rational(180) - Rational(1) / power(Rational(10), nines),
                                      Rational(1, 2), Rational(1, 2));
    EXPECT_FALSE(smallest_edge_exponent(edge, Rational(1, 1000))) << nines;
    EXPECT_FALSE(edge_exponents(edge, 2, 10)) << nines;
  }
}

}  // namespace
}  // namespace radcert
