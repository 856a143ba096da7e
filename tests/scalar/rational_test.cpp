// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/rational.h"

#include <bit>
#include <climits>
#include <cmath>
#include <compare>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "radcert/core/text.h"

namespace {

using radcert::ContractViolation, radcert::Outcome, radcert::Rational;

/// Numbers at which arithmetic goes wrong, and ordinary ones.
class RationalSource {
public:
  Rational operator()() {
    static constexpr long corners[] = {0,        1,        -1,           2,        -2,      3, 10,
                                       LONG_MAX, LONG_MIN, LONG_MAX - 1, 1L << 32, 1L << 53};
    const auto number = [&]() -> long {
      if (random_() % 2 == 0) return corners[random_() % std::size(corners)];
      return static_cast<long>(random_()) >> (random_() % 64);
    };
    long denominator = number();
    if (denominator == 0) denominator = 1;
    Rational q(number(), denominator);
    if (random_() % 4 == 0) q *= q * q;
    return q;
  }

private:
  std::mt19937_64 random_{11};
};

TEST(Rational, IsAField) {
  RationalSource random;
  for (int trial = 0; trial < 2000; ++trial) {
    const Rational a = random();
    const Rational b = random();
    const Rational c = random();
    SCOPED_TRACE(a.to_text() + ", " + b.to_text() + ", " + c.to_text());
    ASSERT_EQ(a + b, b + a);
    ASSERT_EQ(a * b, b * a);
    ASSERT_EQ((a + b) + c, a + (b + c));
    ASSERT_EQ((a * b) * c, a * (b * c));
    ASSERT_EQ(a * (b + c), a * b + a * c);
    ASSERT_EQ(a - b, a + -b);
    ASSERT_EQ(a - a, Rational(0));
    if (b.sign() != 0) {
      ASSERT_EQ(a / b * b, a);
    }
  }
}

TEST(Rational, IsOrderedLikeTheDifference) {
  RationalSource random;
  for (int trial = 0; trial < 2000; ++trial) {
    const Rational a = random();
    const Rational b = random();
    ASSERT_EQ(a <=> b, (a - b).sign() <=> 0) << a.to_text() << ", " << b.to_text();
    ASSERT_EQ(abs(a), a < Rational(0) ? -a : a);
    ASSERT_EQ(a == b, (a <=> b) == 0);
  }
  EXPECT_LT(Rational(1, 3), Rational(1, 2));
  EXPECT_GT(Rational(-1, 3), Rational(-1, 2));
}

TEST(Rational, IsInLowestTermsWithAPositiveDenominator) {
  EXPECT_EQ(Rational(6, -4).to_text(), "-3/2");
  EXPECT_EQ(Rational(-6, -3).to_text(), "2");
  EXPECT_EQ(Rational(0, -7).to_text(), "0");
  EXPECT_EQ(Rational(LONG_MIN, LONG_MIN), Rational(1));
  EXPECT_EQ(Rational(1, LONG_MIN).to_text(), "-1/9223372036854775808");
  EXPECT_EQ(Rational(6, -4).numerator_text(), "-3");
  EXPECT_EQ(Rational(6, -4).denominator_text(), "2");
  EXPECT_EQ(Rational(6, -4).numerator(), Rational(-3));
  EXPECT_EQ(Rational(6, -4).denominator(), Rational(2));
}

TEST(Rational, TakesEveryInteger) {
  EXPECT_EQ(Rational(UINT64_MAX).to_text(), "18446744073709551615");
  EXPECT_EQ(Rational(INT64_MIN).to_text(), "-9223372036854775808");
  EXPECT_EQ(2 * Rational(1, 2), 1);
  EXPECT_EQ(Rational(INT64_MIN).to_long(), INT64_MIN);
  EXPECT_FALSE(Rational(UINT64_MAX).to_long().has_value());
  EXPECT_FALSE(Rational(1, 2).to_long().has_value());
  EXPECT_TRUE(Rational(4, 2).is_integer());
  EXPECT_FALSE(Rational(1, 2).is_integer());
  static_assert(!std::is_constructible_v<Rational, double> && !std::is_constructible_v<Rational, float> &&
                    !std::is_constructible_v<Rational, bool>,
                "a rounded number enters by exactly() only");
}

TEST(Rational, RefusesZeroDenominators) {
  EXPECT_THROW(Rational(1, 0), ContractViolation);
  EXPECT_THROW((void)(Rational(1) / Rational(0)), ContractViolation);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)Rational::exactly(value), ContractViolation);
  }
}

TEST(Rational, CopiesAreIndependentAndMovesExchange) {
  Rational a(1, 3);
  Rational b = a;
  b += Rational(1);
  EXPECT_EQ(a, Rational(1, 3));
  Rational c = std::move(b);
  EXPECT_EQ(c, Rational(4, 3));
  b = Rational(5);  // a moved-from value may be assigned to
  EXPECT_EQ(b, Rational(5));
  swap(a, c);
  EXPECT_EQ(a, Rational(4, 3));
  Rational& same = a;
  a = same;
  a += a;
  EXPECT_EQ(a, Rational(8, 3));
  a /= a;
  EXPECT_EQ(a, Rational(1));
  std::vector<Rational> many;
  for (int i = 1; i < 100; ++i) many.emplace_back(1, i);
  EXPECT_EQ(many[50], Rational(1, 51));
}

TEST(RationalParse, IsExact) {
  const auto parsed = [](const char* text) { return Rational::parse(text).value(); };
  EXPECT_EQ(parsed("0.1"), Rational(1, 10));
  EXPECT_EQ(parsed("1/6"), Rational(1, 6));
  EXPECT_EQ(parsed("-1.5e-3"), Rational(-3, 2000));
  EXPECT_EQ(parsed("+2"), Rational(2));
  EXPECT_EQ(parsed(".5"), Rational(1, 2));
  EXPECT_EQ(parsed("2."), Rational(2));
  EXPECT_EQ(parsed("007"), Rational(7));
  EXPECT_EQ(parsed("1E+2"), Rational(100));
  EXPECT_EQ(parsed("-0.5/1.5"), Rational(-1, 3));
  EXPECT_EQ(parsed("1e1/1e-1"), Rational(100));
  EXPECT_EQ(parsed("-0"), Rational(0));
  EXPECT_EQ(parsed("0/3"), Rational(0));
  EXPECT_EQ(parsed("1e400") * parsed("1e-400"), Rational(1));
  EXPECT_EQ(parsed("1e400").numerator_text(), "1" + std::string(400, '0'));
}

TEST(RationalParse, ReadsBackItsText) {
  RationalSource random;
  for (int trial = 0; trial < 1000; ++trial) {
    const Rational q = random();
    ASSERT_EQ(Rational::parse(q.to_text()).value(), q) << q.to_text();
  }
}

TEST(RationalParse, RefusesWithAReason) {
  for (const char* text : {"",      "-",     "+",   ".",     "e5",      ".e5",
                           "1e",    "1e+",   "1e-", "1e+-5", "1e--5",   "1..2",
                           "1.2.3", "1/",    "/2",  "1/2/3", "1/-2",    "1/+2",
                           "--1",   "+-1",   " 1",  "1 ",    "1 /2",    "1,5",
                           "0x10",  "inf",   "nan", "1e401", "1e-401",  "1e99999999999999999999",
                           "1/0",   "1/0.0", "0/0", "1/0e9", "\xd9\xa1"}) {
    const Outcome<Rational> outcome = Rational::parse(text);
    ASSERT_FALSE(outcome.has_value()) << text;
    EXPECT_FALSE(outcome.reason().empty()) << text;
  }
  EXPECT_FALSE(Rational::parse(std::string_view("1\0", 2)).has_value());
  EXPECT_TRUE(Rational::parse(std::string(1000, '9')).has_value());
  EXPECT_FALSE(Rational::parse(std::string(1001, '9')).has_value());
  EXPECT_FALSE(Rational::parse(std::string(10000000, '9')).has_value());
  EXPECT_EQ(Rational::parse("1/0").reason(), "the denominator is zero");
}

TEST(RationalToDouble, InvertsExactly) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    // Every fourth one subnormal.
    const double value = std::bit_cast<double>(trial % 4 == 0 ? random() >> 12U : random());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(Rational::exactly(value).to_double(), value) << radcert::shortest(value);
  }
  EXPECT_EQ(Rational::exactly(0.1).to_text(), "3602879701896397/36028797018963968");
  EXPECT_EQ(Rational::exactly(5e-324).to_double(), 5e-324);
  EXPECT_EQ(Rational::exactly(-std::numeric_limits<double>::max()).to_double(),
            -std::numeric_limits<double>::max());
}

/// The bound between two neighbouring doubles goes to the even one; a little to either side goes to the
/// nearer one.
void expect_nearest_around(double low, double high) {
  SCOPED_TRACE(radcert::shortest(low) + " and " + radcert::shortest(high));
  const Rational a = Rational::exactly(low);
  const Rational b = Rational::exactly(high);
  const Rational middle = (a + b) / Rational(2);
  const Rational little = (b - a) / Rational(LONG_MAX);
  const double even = (std::bit_cast<std::uint64_t>(low) & 1U) == 0 ? low : high;
  EXPECT_EQ(middle.to_double(), even);
  EXPECT_EQ((-middle).to_double(), -even);
  EXPECT_EQ((middle - little).to_double(), low);
  EXPECT_EQ((middle + little).to_double(), high);
}

TEST(RationalToDouble, RoundsToNearestTiesToEven) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 5000; ++trial) {
    const double low = std::abs(std::bit_cast<double>(trial % 4 == 0 ? random() >> 12U : random()));
    const double high = std::nextafter(low, INFINITY);
    if (!std::isfinite(high)) continue;
    expect_nearest_around(low, high);
  }
  const double smallest_normal = std::numeric_limits<double>::min();
  for (const double low :
       {0.0, 5e-324, std::nextafter(smallest_normal, 0), smallest_normal, std::nextafter(1.0, 0), 1.0,
        std::nextafter(2.0, 0), std::nextafter(std::numeric_limits<double>::max(), 0)}) {
    expect_nearest_around(low, std::nextafter(low, INFINITY));
  }
}

TEST(RationalToDouble, AgreesWithTheDecimalReaderOfTheLibrary) {
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 5000; ++trial) {
    std::string text = std::to_string(random()) + "." + std::to_string(random()) + "e" +
                       std::to_string(static_cast<int>(random() % 640) - 330);
    const auto expected = radcert::parse_double(text);
    if (!expected) continue;
    ASSERT_EQ(Rational::parse(text).value().to_double(), *expected) << text;
  }
}

TEST(RationalToDouble, OverflowsToInfinityAndUnderflowsToZero) {
  const Rational largest = Rational::exactly(std::numeric_limits<double>::max());
  const Rational half_step = Rational::exactly(std::ldexp(1.0, 970));
  EXPECT_EQ((largest + half_step).to_double(), INFINITY);
  EXPECT_EQ((largest + half_step - Rational(1)).to_double(), std::numeric_limits<double>::max());
  EXPECT_EQ((-largest * largest).to_double(), -INFINITY);
  EXPECT_EQ((Rational(1) / (largest * largest)).to_double(), 0.0);
  const Rational half_smallest = Rational::exactly(5e-324) / Rational(2);
  EXPECT_EQ(half_smallest.to_double(), 0.0);
  EXPECT_EQ((half_smallest * Rational(1000001, 1000000)).to_double(), 5e-324);
}

}  // namespace
