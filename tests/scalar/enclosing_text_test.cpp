// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/enclosing_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Rational read(const std::string& text) { return Rational::parse(text).value(); }

/// Any bits that are a finite double, powers of ten and their neighbours, 9.99..., halves of a last digit,
/// denormal numbers.
double nasty_or_infinite(Draw& draw) {
  const double sign = draw.below(2) == 0 ? 1 : -1;
  const auto neighbour = [&](double x) {
    const std::size_t steps = draw.below(3);
    for (std::size_t i = 0; i < steps; ++i) x = std::nextafter(x, draw.below(2) == 0 ? infinity : 0.0);
    return x;
  };
  const auto power_of_ten = [&] { return std::pow(10.0, static_cast<double>(draw.below(617)) - 308); };
  switch (draw.below(6)) {
    case 0: {
      const std::uint64_t bits = draw.bits();
      double x = 0;
      std::memcpy(&x, &bits, sizeof x);
      return std::isnan(x) ? 1.0 : x;
    }
    case 1: return sign * neighbour(power_of_ten());
    case 2: return sign * neighbour(power_of_ten() * static_cast<double>(1 + draw.below(999)) / 8);
    case 3: return sign * static_cast<double>(draw.bits() >> (12 + draw.below(52))) * 5e-324;
    case 4:
      return sign * neighbour((1 - std::pow(10.0, -static_cast<double>(draw.below(18)))) * power_of_ten());
    default: return draw.number();
  }
}

double nasty(Draw& draw) {
  const double x = nasty_or_infinite(draw);
  return std::isfinite(x) ? x : std::numeric_limits<double>::max();
}

DecimalForm some_form(Draw& draw) {
  switch (draw.below(4)) {
    case 3: return DecimalForm::padded(1 + static_cast<int>(draw.below(20)));
    case 0: return DecimalForm::scientific(1 + static_cast<int>(draw.below(20)));
    case 1: return DecimalForm::general(1 + static_cast<int>(draw.below(20)));
    default: return DecimalForm::fixed(static_cast<int>(draw.below(12)));
  }
}

TEST(EnclosingText, ContainsEveryPointOfTheNumberAndItsRadius) {
  Draw draw(1);
  for (int i = 0; i < 60000; ++i) {
    const double value = nasty(draw);
    const double radius = draw.below(5) == 0 ? 0 : std::abs(nasty(draw));
    const DecimalForm form = some_form(draw);
    const EnclosingText text = enclosing_text(value, radius, form);
    const Rational needed = abs(Rational::exactly(value) - read(text.value)) + Rational::exactly(radius);
    ASSERT_LE(needed, read(text.radius)) << value << " " << radius << " " << text.value << " " << text.radius;
    // Two digits: no more than a tenth too wide.
    if (form.kind() != DecimalForm::Kind::fixed) {
      ASSERT_LE(read(text.radius) * Rational(10), needed * Rational(11)) << value << " " << radius;
    }
  }
}

TEST(EnclosingText, HasARadiusExactlyWhereSomethingIsNotKnownOrCut) {
  const EnclosingText exact = enclosing_text(0.25, 0.0, DecimalForm::scientific(3));
  EXPECT_EQ(exact.value, "2.50e-01");
  EXPECT_EQ(exact.radius, "0");
  EXPECT_EQ(enclosing_text(0.25, 0.0, DecimalForm::scientific(1)).radius, "5e-2");
  // The double 0.1 is not a tenth.
  EXPECT_EQ(enclosing_text(0.1, 0.0, DecimalForm::general(17)).radius, "4.5e-18");
  EXPECT_EQ(enclosing_text(Rational(1, 10), Rational(0), DecimalForm::general(17)).radius, "0");
  EXPECT_EQ(enclosing_text(Rational(1, 3), Rational(0), DecimalForm::fixed(2)).radius, "0.01");
  const EnclosingText unbounded = enclosing_text(2.0, infinity, DecimalForm::general(3));
  EXPECT_EQ(unbounded.value, "2");
  EXPECT_EQ(unbounded.radius, "inf");
}

TEST(EnclosingText, RefusesWhatIsNoNumberWithARadius) {
  EXPECT_THROW((void)enclosing_text(infinity, 1, DecimalForm::general(3)), ContractViolation);
  EXPECT_THROW((void)enclosing_text(std::nan(""), 1, DecimalForm::general(3)), ContractViolation);
  EXPECT_THROW((void)enclosing_text(1, -1, DecimalForm::general(3)), ContractViolation);
  EXPECT_THROW((void)enclosing_text(1, std::nan(""), DecimalForm::general(3)), ContractViolation);
  EXPECT_THROW((void)DecimalForm::scientific(0), ContractViolation);
  EXPECT_THROW((void)DecimalForm::fixed(-1), ContractViolation);
}

/// Whether a decimal text has the least decimal of `digits` digits that is not below the number: one unit
/// less is below it.
void expect_least(const std::string& text, const Rational& number, int digits, bool upwards) {
  const Rational shown = read(text);
  const Rational slack = upwards ? shown - number : number - shown;
  ASSERT_GE(slack.sign(), 0) << text;
  if (number.sign() == 0) return;
  // A unit of the last digit of |number|, whose first digit is found by comparison.
  Rational unit = power(Rational(10),
                        static_cast<long>(std::floor(std::log10(std::abs(number.to_double())))) + 1 - digits);
  while (abs(number) >= Rational(10) * unit * power(Rational(10), digits - 1)) unit *= Rational(10);
  while (abs(number) < unit * power(Rational(10), digits - 1)) unit /= Rational(10);
  ASSERT_LT(slack, unit) << text;
  ASSERT_TRUE((shown / unit).is_integer()) << text;
}

TEST(UpperText, IsTheLeastDecimalThatIsNotBelow) {
  Draw draw(2);
  for (int i = 0; i < 20000; ++i) {
    const double bound = nasty(draw);
    const int digits = 1 + static_cast<int>(draw.below(18));
    const DecimalForm form =
        draw.below(2) == 0 ? DecimalForm::scientific(digits) : DecimalForm::general(digits);
    SCOPED_TRACE(testing::Message() << bound << " " << digits);
    expect_least(upper_text(bound, form), Rational::exactly(bound), digits, true);
    expect_least(lower_text(bound, form), Rational::exactly(bound), digits, false);
  }
}

// The comparison alone, of many more.
TEST(UpperText, IsNeverBelow) {
  Draw draw(3);
  for (int i = 0; i < 100000; ++i) {
    const double bound = nasty(draw);
    const Rational exact = Rational::exactly(bound);
    const DecimalForm form = some_form(draw);
    ASSERT_LE(exact, read(upper_text(bound, form))) << bound;
    ASSERT_LE(exact, read(upper_text(bound))) << bound;
    ASSERT_GE(exact, read(lower_text(bound, form))) << bound;
  }
}

TEST(UpperText, KnowsTheEnds) {
  EXPECT_EQ(upper_text(0.0), "0");
  EXPECT_EQ(upper_text(1e-13), "1.1e-13");  // the double lies above 1e-13
  EXPECT_EQ(upper_text(9.95e-5), "1e-4");
  EXPECT_EQ(upper_text(9.95e-5, DecimalForm::general(2)), "0.0001");
  EXPECT_EQ(upper_text(0.0421), "4.3e-2");
  EXPECT_EQ(upper_text(149.0), "1.5e2");
  EXPECT_EQ(upper_text(-0.129), "-0.12");
  EXPECT_EQ(lower_text(-0.121, DecimalForm::general(2)), "-0.13");
  EXPECT_EQ(upper_text(99.1, DecimalForm::scientific(2)), "1.0e+02");
  EXPECT_EQ(upper_text(5e-324), "5e-324");
  EXPECT_EQ(upper_text(std::numeric_limits<double>::max()), "1.8e308");
  EXPECT_EQ(upper_text(infinity), "inf");
  EXPECT_EQ(upper_text(std::nan("")), "inf");
  EXPECT_EQ(lower_text(std::nan(""), DecimalForm::general(2)), "-inf");
  EXPECT_EQ(lower_text(infinity, DecimalForm::general(2)), "inf");
  EXPECT_EQ(upper_text_below_one(0.25, 3), "0.25");
  EXPECT_EQ(upper_text_below_one(0.999915, 3), "0.99992");
  EXPECT_EQ(upper_text_below_one(std::nextafter(1.0, 0.0), 3), "0.9999999999999999");
  EXPECT_THROW((void)upper_text_below_one(1, 3), ContractViolation);
}

TEST(NearestText, AgreesWithPrintf) {
  Draw draw(4);
  for (int i = 0; i < 40000; ++i) {
    const double value = nasty(draw);
    const int digits = 1 + static_cast<int>(draw.below(20));
    std::array<char, 400> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, value);
    // printf keeps the sign of zero.
    const std::string expected = value == 0 && std::signbit(value) ? buffer.data() + 1 : buffer.data();
    ASSERT_EQ(nearest_text(value, DecimalForm::scientific(digits)), expected);
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    ASSERT_EQ(read(nearest_text(value, DecimalForm::general(digits))), read(buffer.data())) << buffer.data();
    const int decimals = static_cast<int>(draw.below(10));
    std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
    ASSERT_EQ(read(nearest_text(value, DecimalForm::fixed(decimals))), read(buffer.data())) << buffer.data();
  }
  EXPECT_EQ(nearest_text(-0.001, DecimalForm::fixed(2)), "0.00");
  EXPECT_EQ(nearest_text(100.0, DecimalForm::general(6)), "100");
  EXPECT_EQ(nearest_text(1234567.0, DecimalForm::general(3)), "1.23e6");
  EXPECT_EQ(nearest_text(Rational(2, 3), DecimalForm::fixed(3)), "0.667");
  EXPECT_EQ(nearest_text(Rational(4, 5), DecimalForm::padded(3)), "0.800");
  EXPECT_EQ(nearest_text(Rational(400), DecimalForm::padded(3)), "400");
  EXPECT_EQ(nearest_text(Rational(1, 100000), DecimalForm::padded(3)), "1.00e-5");
}

/// What "1.484(21)e-3" says: midpoint and radius.
std::array<Rational, 2> read_parenthesised(const std::string& text) {
  const std::size_t open = text.find('(');
  const std::size_t e = text.find('e');
  const std::string power = e == std::string::npos ? "0" : text.substr(e + 1);
  const std::string mantissa = text.substr(0, std::min(open, e));
  const Rational midpoint = read(mantissa + "e" + power);
  if (open == std::string::npos) return {midpoint, Rational(0)};
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  const std::string units = text.substr(open + 1, text.find(')') - open - 1);
  return {midpoint, read(units + "e" + std::to_string(std::stol(power) - static_cast<long>(decimals)))};
}

TEST(ParenthesisedText, ContainsTheNumberAndItsRadius) {
  Draw draw(5);
  for (int i = 0; i < 20000; ++i) {
    const double value = nasty(draw);
    const double radius = draw.below(4) == 0   ? 0
                          : draw.below(2) == 0 ? std::abs(nasty(draw))
                                               : std::abs(value) * std::pow(10.0, -12 * draw.unit());
    if (!std::isfinite(radius)) continue;
    const int digits = 1 + static_cast<int>(draw.below(18));
    const std::string text = parenthesised_text(value, radius, digits);
    const auto [midpoint, around] = read_parenthesised(text);
    const Rational needed = abs(Rational::exactly(value) - midpoint) + Rational::exactly(radius);
    ASSERT_LE(needed, around) << text << " " << value << " " << radius;
  }
}

TEST(ParenthesisedText, IsWrittenAsInPapers) {
  EXPECT_EQ(parenthesised_text(0.0014836, 2.05e-6, 5), "1.4836(21)e-3");
  EXPECT_EQ(parenthesised_text(0.0014836, 2.05e-6, 4), "1.484(3)e-3");
  EXPECT_EQ(parenthesised_text(0.0014836, 2.05e-5, 8), "1.484(21)e-3");
  EXPECT_EQ(parenthesised_text(0.5, 0, 4), "5.000e-1");
  EXPECT_EQ(parenthesised_text(-2.5, 0.25, 3), "-2.50(25)");
  EXPECT_EQ(parenthesised_text(3, 7000, 4), "0(71)e2");
  EXPECT_EQ(parenthesised_text(0, 1.5e-7, 4), "0(15)e-8");
  EXPECT_EQ(parenthesised_text(0, 0, 4), "0");
  EXPECT_EQ(parenthesised_text(9.9996e-10, 1e-16, 4), "1.000(1)e-9");
}

}  // namespace
}  // namespace radcert
