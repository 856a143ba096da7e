// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/parse.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <utility>

namespace {

using radcert::Expression, radcert::ExpressionKind, radcert::ExpressionVariables, radcert::parse_expression,
    radcert::Rational;

double value(std::string_view text, double x = 0, double y = 0, double z = 0) {
  const auto parsed = parse_expression(text);
  EXPECT_TRUE(parsed.has_value()) << text << ": " << (parsed ? "" : parsed.reason().to_text());
  return parsed ? parsed->evaluate<double>({x, y, z}) : std::numeric_limits<double>::quiet_NaN();
}

TEST(ParseExpression, FollowsThePrecedenceOfMathematics) {
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("7-4-2"), 1);
  EXPECT_EQ(value("16/4/2"), 2);
  EXPECT_EQ(value("16/4*2"), 8);
  EXPECT_EQ(value("1-2+3"), 2);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("(2^3)^2"), 64);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("(-2)^2"), 4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2^-2^2"), 0.0625);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("1--1"), 2);
  EXPECT_EQ(value("--1"), 1);
  EXPECT_EQ(value("-x*y", 2, 3), -6);
  EXPECT_EQ(value("4^0.5"), 2);
  EXPECT_EQ(value("2*3^2"), 18);
}

TEST(ParseExpression, KnowsItsNames) {
  EXPECT_EQ(value("x+10*y+100*z", 1, 2, 3), 321);
  EXPECT_EQ(value("pi"), std::numbers::pi);
  EXPECT_EQ(value("sqrt(9)"), 3);
  EXPECT_EQ(value("exp(x)", 1), std::exp(1.0));
  EXPECT_EQ(value("log(x)", 2), std::log(2.0));
  EXPECT_EQ(value("sin(x)", 1), std::sin(1.0));
  EXPECT_EQ(value("cos(x)", 1), std::cos(1.0));
  EXPECT_EQ(value("tan(x)", 1), std::tan(1.0));
  EXPECT_EQ(value("atan(x)", 1), std::atan(1.0));
  EXPECT_EQ(value("abs(x)", -2), 2);
  EXPECT_EQ(value("min(x, 1)", 2), 1);
  EXPECT_EQ(value("max(x, 1)", 2), 2);
  EXPECT_EQ(value("min(max(x,y)+1, z)", 4, 5, 9), 6);
}

TEST(ParseExpression, TakesBlanksAnywhereBetweenWords) {
  EXPECT_EQ(value(" \t 1 + 2 * ( 3 - x ) ^ 2 / min ( 1 , 2 ) ", 1), 9);
}

TEST(ParseExpression, KeepsTheTextAndTheTree) {
  const Expression ratio = parse_expression(" x/x ").value();
  EXPECT_EQ(ratio.text(), " x/x ");
  ASSERT_EQ(ratio.nodes().size(), 3U);
  EXPECT_EQ(ratio.nodes().back().kind, ExpressionKind::divide);
  EXPECT_TRUE(std::isnan(ratio.evaluate<double>({0, 0, 0})));
  EXPECT_EQ(parse_expression("0*x").value().nodes().size(), 3U);
}

TEST(ParseExpression, KeepsNumbersExact) {
  const auto literal = [](const char* text) { return parse_expression(text).value().is_constant(); };
  EXPECT_EQ(literal("0.1"), Rational(1, 10));
  EXPECT_EQ(literal("1e-3"), Rational(1, 1000));
  EXPECT_EQ(literal("(.5)"), Rational(1, 2));
  EXPECT_EQ(literal("2."), Rational(2));
  EXPECT_EQ(literal("-1.5E+1"), Rational(-15));
  EXPECT_EQ(literal("1/6"), Rational(1, 6));
  EXPECT_EQ(literal("-1/-0.6"), Rational(5, 3));
  for (const char* text : {"x", "pi", "1+1", "1/0", "--1", "2^2", "1/2/3", "x-x"})
    EXPECT_FALSE(literal(text).has_value()) << text;
}

TEST(ParseExpression, ReadsAFunctionOfTheRadius) {
  const auto gaussian = parse_expression("exp(-r^2/2)", ExpressionVariables::radius).value();
  EXPECT_EQ(gaussian.evaluate_radial(2.0), std::exp(-2.0));
  EXPECT_THROW((void)gaussian.evaluate<double>({1, 2, 3}), radcert::ContractViolation);
  EXPECT_THROW((void)parse_expression("x").value().evaluate_radial(1.0), radcert::ContractViolation);
  EXPECT_FALSE(parse_expression("r").has_value());
  EXPECT_FALSE(parse_expression("x", ExpressionVariables::radius).has_value());
  const auto bubble = parse_expression("27*x1*x2*x3", ExpressionVariables::barycentric).value();
  for (int variable = 0; variable < 3; ++variable) EXPECT_TRUE(bubble.depends_on(variable));
  EXPECT_FALSE(parse_expression("x", ExpressionVariables::barycentric).has_value());
  EXPECT_FALSE(parse_expression("x1").has_value());
}

TEST(ParseExpression, KnowsWhichVariablesOccur) {
  const Expression expression = parse_expression("x + z^2").value();
  EXPECT_TRUE(expression.depends_on(0));
  EXPECT_FALSE(expression.depends_on(1));
  EXPECT_TRUE(expression.depends_on(2));
}

struct Bad {
  const char* text;
  std::size_t column;
  const char* part;
};

TEST(ParseExpression, SaysWhereAndWhatWasExpected) {
  const Bad bad[] = {
      {"", 1, "expected a number, x, y, z, pi, a function or '(', found the end"},
      {"   ", 4, "found the end"},
      {"1..2", 3, "expected an operator or the end, found \".\""},
      {".", 2, "expected a digit, found the end"},
      {"sin", 4, "expected '(' after the name of a function, found the end"},
      {"sin x", 5, "expected '(' after"},
      {"sin()", 5, "expected a number"},
      {"sin(x", 6, "expected an operator or ')', found the end"},
      {"sin(1, 2)", 6, "expected an operator or ')', found \",\""},
      {"min(1)", 6, "two arguments"},
      {"min(1, 2, 3)", 9, "two arguments"},
      {"x y", 3, "expected an operator or the end, found \"y\""},
      {"2x", 2, "expected an operator or the end"},
      {"2e", 2, "expected an operator or the end"},
      {"2(3)", 2, "expected an operator or the end"},
      {"x(3)", 2, "expected an operator or the end"},
      {"(1", 3, "expected an operator or ')'"},
      {"1)", 2, "expected an operator or the end, found \")\""},
      {"()", 2, "expected a number"},
      {"1+", 3, "expected a number"},
      {"*1", 1, "expected a number"},
      {"+1", 1, "expected a number"},
      {"1+*2", 3, "expected a number"},
      {"1^", 3, "expected a number"},
      {"x^+2", 3, "expected a number"},
      {"x**2", 2, "a power is written with ^"},
      {"1 - foo", 5, "unknown name \"foo\"; known: x, y, z, pi, sqrt"},
      {"sinx", 1, "unknown name"},
      {"Sin(x)", 1, "unknown name"},
      {"pix", 1, "unknown name"},
      {"_", 1, "unknown name"},
      {"1 + 1e500", 5, "exponent"},
      {"1,2", 2, "expected an operator or the end"},
      {"x\n", 2, "no expression has"},
      {"x+\xc3\xa4", 3, "no expression has: \"\\xc3\""},
      {"\xff\xfe", 1, "no expression has"},
      {"x\x7f", 2, "no expression has"},
      {"x$", 2, "expected an operator or the end"},
  };
  for (const Bad& one : bad) {
    const auto parsed = parse_expression(one.text);
    ASSERT_FALSE(parsed.has_value()) << one.text;
    EXPECT_EQ(parsed.reason().column, one.column) << one.text << ": " << parsed.reason().message;
    EXPECT_NE(parsed.reason().message.find(one.part), std::string::npos)
        << one.text << ": " << parsed.reason().message;
  }
  EXPECT_EQ(parse_expression("1+").reason().to_text().substr(0, 10), "column 3: ");
  EXPECT_EQ(parse_expression(std::string_view("1\0", 2)).reason().column, 2U);
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

TEST(ParseExpression, NestsToDepth64AndNoDeeper) {
  const auto nested = [](const std::string& before, const std::string& after, int depth) {
    return parse_expression(repeated(before, depth) + "x" + repeated(after, depth));
  };
  const std::pair<const char*, const char*> ways[] = {{"(", ")"},    {"-", ""},       {"2^", ""},
                                                      {"sin(", ")"}, {"min(1,", ")"}, {"1-(", ")"}};
  for (const auto& [before, after] : ways) {
    EXPECT_TRUE(nested(before, after, 64).has_value()) << before;
    const auto deeper = nested(before, after, 65);
    ASSERT_FALSE(deeper.has_value()) << before;
    EXPECT_NE(deeper.reason().message.find("nested more than 64"), std::string::npos)
        << deeper.reason().message;
  }
  EXPECT_EQ(nested("(", ")", 65).reason().column, 66U);
  // Depth is that of the nesting: what stands side by side does not add up.
  EXPECT_TRUE(parse_expression(repeated("((x))+", 600) + "1").has_value());
}

TEST(ParseExpression, RefusesHugeTexts) {
  EXPECT_EQ(value(repeated("1+", 2047) + "12"), 2059);
  for (const std::string& text : {std::string(100000, '('), std::string(100000, '-'), repeated("2^", 100000),
                                  std::string(4097, '1'), std::string(50000000, 'x')}) {
    const auto parsed = parse_expression(text);
    ASSERT_FALSE(parsed.has_value());
    EXPECT_EQ(parsed.reason().column, 4097U);
  }
  EXPECT_FALSE(parse_expression(std::string(4096, '(')).has_value());
  EXPECT_FALSE(parse_expression(std::string(4096, '9')).has_value());
}

TEST(ParseExpression, SurvivesRandomText) {
  static constexpr std::string_view pieces[] = {
      "x", "y", "z", "pi", "1",   "2.5",  "1e-3", ".",    "e",     "+",    "-",  "*",    "/",   "^",
      "(", ")", ",", " ",  "sin", "sin(", "min(", "max(", "sqrt(", "abs(", "\t", "\xff", "foo", "1e999"};
  std::mt19937_64 random(3);
  int admitted = 0;
  for (int trial = 0; trial < 50000; ++trial) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) text += pieces[random() % std::size(pieces)];
    const auto parsed = parse_expression(text);
    if (parsed) {
      ++admitted;
      (void)parsed->evaluate<double>({1, 2, 3});
    } else {
      ASSERT_GE(parsed.reason().column, 1U) << text;
      ASSERT_LE(parsed.reason().column, text.size() + 1) << text;
    }
  }
  EXPECT_GT(admitted, 100);
}

}  // namespace
