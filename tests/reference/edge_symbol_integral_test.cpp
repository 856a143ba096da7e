// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/edge_symbol_integral.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>

#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/reference/reference_value.h"

namespace radcert::reference {
namespace {

Ball radians(const Rational& degrees) { return Ball::pi() * Ball(degrees / Rational(180)); }

// The closed form and the integral, in the strip where it converges and beyond, real and not.
TEST(EdgeSymbolIntegral, IsTheClosedForm) {
  const BallPrecision precision(160);
  for (const long degrees : {15, 60, 90, 150})
    for (const auto& [re, im] : {std::pair{Rational(1, 3), Rational(0)},
                                 {Rational(-3, 2), Rational(0)},
                                 {Rational(5, 2), Rational(0)},
                                 {Rational(7, 2), Rational(3, 2)},
                                 {Rational(19, 4), Rational(-1, 3)}}) {
      const ComplexBall b{Ball(re), Ball(im)};
      const EdgeSymbolIntegral integral(radians(degrees));
      const EdgeSymbol symbol(radians(degrees));
      const auto k = integral.at(b, 0, 1e-20);
      const auto slope = integral.at(b, 1, 1e-20);
      ASSERT_TRUE(k && slope);
      EXPECT_TRUE(overlaps(*k, symbol(b))) << degrees << " " << re.to_text() << " " << im.to_text();
      EXPECT_LT(k->real().radius(), 1e-17);
      const ComplexBall step(Rational(1) / power(Rational(10), 12));
      const ComplexBall difference = (symbol(b + step) - symbol(b - step)) / (ComplexBall(2) * step);
      EXPECT_LT((difference - *slope).magnitude_bound(), 1e-15) << degrees << " " << re.to_text();
      // The bound of the second derivative, against differences.
      const ComplexBall second =
          (symbol(b + step) - ComplexBall(2) * symbol(b) + symbol(b - step)) / (step * step);
      const Ball bound = integral.second_derivative_bound(b, Ball(Rational(1, 1000)));
      EXPECT_LT(second.magnitude_bound(), bound.upper_double());
      EXPECT_LT(bound.upper_double(), 1e6);
    }
}

// Each exponent, complex ones included, is found again by the integral alone.
TEST(EdgeSymbolIntegral, FindsEachExponentAgain) {
  for (const auto& [degrees, rho] :
       {std::pair{90L, Rational(9, 10)}, {60L, Rational(1, 2)}, {130L, Rational(2, 3)}}) {
    const auto all = edge_exponents(edge_of_degrees(degrees, rho, rho), Rational(9, 2), 20);
    ASSERT_TRUE(all) << all.reason();
    bool is_complex = false;
    for (const EdgeExponent& exponent : *all) {
      is_complex = is_complex || !exponent.value.is_real();
      const auto again = edge_zero_near(degrees, rho * rho, exponent.symmetric ? 1 : -1, exponent.value,
                                        Rational(1) / power(Rational(10), 15));
      ASSERT_TRUE(again) << again.reason();
      EXPECT_TRUE(overlaps(*again, exponent.value)) << again->to_text() << " " << exponent.value.to_text();
      // For the other sign there is none.
      const auto other = edge_zero_near(degrees, rho * rho, exponent.symmetric ? -1 : 1, exponent.value,
                                        Rational(1) / power(Rational(10), 15));
      EXPECT_FALSE(other && overlaps(*other, exponent.value));
    }
    EXPECT_TRUE(is_complex) << degrees;
  }
}

TEST(EdgeSymbolIntegral, HasNoBoundOfItsSecondDerivativeWhereADiskMayReachAPole) {
  const EdgeSymbolIntegral integral(Ball::pi() / Ball(3));
  const ComplexBall near_one(Rational(999, 1000));
  EXPECT_TRUE(integral.second_derivative_bound(near_one, Ball(Rational(1, 10000))).is_finite());
  for (const Rational& by : {Rational(1, 1000), Rational(1, 100), Rational(1, 8)})
    EXPECT_FALSE(integral.second_derivative_bound(near_one, Ball(by)).is_finite()) << by.to_text();
}

// A disk of the radius asked for would reach a pole: a smaller one has the zero, and no other.
TEST(EdgeSymbolIntegral, FindsExponentsNearerToAPoleThanTheRadius) {
  for (const auto& [degrees, rho, digits] : {std::tuple{135L, Rational(1, 50), 2},
                                             {60L, Rational(1, 1000), 2},
                                             {75L, Rational(1) / power(Rational(10), 13), 13}}) {
    const auto exact =
        smallest_edge_exponent(edge_of_degrees(degrees, rho, rho), Rational(1) / power(Rational(10), 30));
    ASSERT_TRUE(exact);
    const Rational radius = Rational(1) / power(Rational(10), digits);
    const auto found = edge_zero_near(degrees, rho * rho, 1, ComplexBall(exact->midpoint()), radius);
    ASSERT_TRUE(found) << degrees << ": " << found.reason();
    EXPECT_TRUE(overlaps(found->real(), *exact)) << degrees;
    EXPECT_TRUE(certainly_less(found->real().upper(), Ball(1))) << degrees;
    const auto family = enclose(*find_family("edge_exponent"), {degrees, rho, rho}, digits);
    EXPECT_TRUE(family) << degrees;
  }
}

// At a right angle the family for all angles is the older one, which takes the beta function.
TEST(EdgeExponent, AtARightAngleIsTheOneByTheBetaFunction) {
  for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(9, 10)}) {
    const auto all = enclose(*find_family("edge_exponent"), {90, rho, rho}, 25);
    const auto right = enclose(*find_family("edge_exponent_90"), {rho}, 25);
    ASSERT_TRUE(all && right);
    EXPECT_TRUE(overlaps(all->first.value, right->first.value));
  }
}

}  // namespace
}  // namespace radcert::reference
