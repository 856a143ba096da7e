// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/whole_vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

TEST(WholeNumber, IsTheDoubleScaled) {
  for (const double x : {0.0, 1.0, -3.0, 0.1, -1e30, 0x1p-1074, 0x1.fffffffffffffp100}) {
    const int exponent = x == 0 ? 0 : lowest_exponent(x);
    const Rational unit =
        exponent >= 0 ? power(Rational(2), exponent) : Rational(1) / power(Rational(2), -exponent);
    EXPECT_EQ(WholeNumber::scaled(x, exponent).to_rational() * unit, Rational::exactly(x));
    EXPECT_EQ(WholeNumber::scaled(x, exponent - 70).to_rational() * unit,
              Rational::exactly(x) * power(Rational(2), 70));
    if (x != 0) {
      EXPECT_THROW(WholeNumber::scaled(x, exponent + 1), ContractViolation);
    }
  }
}

TEST(WholeVector, MultipliesAsRationalNumbersDo) {
  sample::Numbers random(61);
  for (int k = 0; k < 100; ++k) {
    const auto vector = [&] {
      return Vector<double>{random.between(-1, 1), random.on_grid(8), std::ldexp(random.fraction(), -100)};
    };
    const WholeVector a = scaled(vector(), -200);
    const WholeVector b = scaled(vector(), -200);
    EXPECT_EQ(to_rational(cross(a, b)), cross(to_rational(a), to_rational(b)));
    EXPECT_EQ(dot(a, b).to_rational(), dot(to_rational(a), to_rational(b)));
    EXPECT_EQ(dot(a, -b).sign(), -dot(a, b).sign());
    EXPECT_EQ(to_rational(a - b), to_rational(a) - to_rational(b));
  }
}

TEST(WholeNumber, DividesToTheLastDigits) {
  sample::Numbers random(63);
  for (int k = 0; k < 200; ++k) {
    const double x = random.between(-1, 1);
    const double y = std::ldexp(random.between(1, 2), -static_cast<int>(random.below(200)));
    const WholeNumber square = WholeNumber::scaled(x, -1000) * WholeNumber::scaled(x, -1000);
    const WholeNumber product =
        WholeNumber::scaled(y, -1000) * WholeNumber::scaled(y, k % 2 == 0 ? -1000 : -400);
    const long double expected = static_cast<long double>(x) * static_cast<long double>(x) /
                                 static_cast<long double>(y) / static_cast<long double>(y);
    const long double value = std::ldexp(quotient(square, product), k % 2 == 0 ? 0 : -600);
    EXPECT_NEAR(static_cast<double>(value / expected - 1), 0, 0x1p-60) << x << " " << y;
  }
  EXPECT_EQ(quotient(WholeNumber(), WholeNumber::scaled(3, 0)), 0.0L);
  EXPECT_EQ(quotient(WholeNumber::scaled(-1, 0), WholeNumber::scaled(4, 0)), -0.25L);
  EXPECT_THROW(static_cast<void>(quotient(WholeNumber::scaled(1, 0), WholeNumber())), ContractViolation);
}

TEST(WholeVector, KeepsItsDirectionInItsLeadingDigits) {
  sample::Numbers random(62);
  for (int k = 0; k < 100; ++k) {
    const int spread = static_cast<int>(random.below(90));
    const Vector<double> v{random.between(-1, 1), std::ldexp(random.fraction(), -spread), 0};
    const WholeVector whole = scaled(v, k % 2 == 0 ? -60 - spread : -500);
    const Vector<long double> digits = leading_digits(whole);
    const long double largest = std::max(std::abs(digits.x), std::abs(digits.y));
    EXPECT_GE(largest, 0x1p63L);
    EXPECT_LT(largest, 0x1p64L);
    const Rational scale = whole.x.sign() == 0 ? Rational(1) : Rational::exactly(v.x);
    // digits.y = digits.x v.y / v.x, each within 1.
    const auto exact = [](long double x) {
      const double head = static_cast<double>(x);
      return Rational::exactly(head) +
             Rational::exactly(static_cast<double>(x - static_cast<long double>(head)));
    };
    const Rational off = exact(digits.y) * scale - exact(digits.x) * Rational::exactly(v.y);
    EXPECT_LE(abs(off), abs(scale) + abs(Rational::exactly(v.y)));
  }
  EXPECT_THROW(static_cast<void>(leading_digits(WholeVector{})), ContractViolation);
}

}  // namespace
}  // namespace radcert
