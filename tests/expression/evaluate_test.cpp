// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/expression.h"
#include "radcert/expression/parse.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

namespace {

using radcert::Expression, radcert::ExpressionKind, radcert::ExpressionNode, radcert::ExpressionVariables,
    radcert::parse_expression, radcert::Rational;

double value(std::string_view text, double x = 0, double y = 0, double z = 0) {
  return parse_expression(text).value().evaluate<double>({x, y, z});
}

/// The same mathematics written by hand: f(x, y, z) as a lambda generic in the arithmetic.
template <class Function>
void expect_same(const char* text, Function by_hand) {
  const Expression expression = parse_expression(text).value();
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    const auto coordinate = [&] { return 3 * (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5); };
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    ASSERT_EQ(expression.evaluate<double>({x, y, z}), by_hand(x, y, z)) << text;
    const long double high = expression.evaluate<long double>({x, y, z});
    ASSERT_NEAR(static_cast<double>(high), by_hand(x, y, z), 1e-13 * (1 + std::abs(by_hand(x, y, z))))
        << text;
  }
}

TEST(EvaluateExpression, EqualsTheFormulaWrittenByHand) {
  expect_same("1/sqrt(x^2 + y^2 + (z-1/2)^2)", [](double x, double y, double z) {
    return 1 / std::sqrt(x * x + y * y + (z - 0.5) * (z - 0.5));
  });
  expect_same("exp(-x^2)*sin(pi*y) - 0.1", [](double x, double y, double) {
    return std::exp(-(x * x)) * std::sin(3.141592653589793 * y) - 0.1;
  });
  expect_same("max(x, y) - min(y, abs(z))",
              [](double x, double y, double z) { return std::max(x, y) - std::min(y, std::abs(z)); });
  expect_same("x^3 / (1 + y^2) + atan(z)",
              [](double x, double y, double z) { return x * (x * x) / (1 + y * y) + std::atan(z); });
}

TEST(EvaluateExpression, RoundsLiteralsOnceFromTheExactNumber) {
  EXPECT_EQ(value("0.1"), 0.1);
  EXPECT_EQ(value("1e-320"), 1e-320);
  EXPECT_EQ(value("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_EQ(value("0.50000000000000005551115123125782702118158340454101562500001"), std::nextafter(0.5, 1.0));
}

TEST(EvaluateExpression, LeavesTheDomainVisibly) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(value("1/0"), infinity);
  EXPECT_EQ(value("-1/0"), -infinity);
  EXPECT_EQ(value("log(0)"), -infinity);
  EXPECT_EQ(value("1e400"), infinity);
  EXPECT_EQ(value("0^-1"), infinity);
  for (const char* text : {"sqrt(-1)", "log(-1)", "0/0", "(-1)^0.5", "1/0-1/0", "min(1, 0/0)", "min(0/0, 1)",
                           "max(1, 0/0)", "max(0/0, 1)", "abs(0/0)"}) {
    EXPECT_TRUE(std::isnan(value(text))) << text;
  }
}

TEST(EvaluateExpression, MultipliesForWholePowers) {
  // pow(-0.1, 3) would do as well; for negative bases and other arithmetics the product is the definition.
  EXPECT_EQ(value("x^2", -1.1), -1.1 * -1.1);
  EXPECT_EQ(value("x^0", 0), 1);
  EXPECT_EQ(value("x^1", -3), -3);
  EXPECT_EQ(value("x^-2", -2), 0.25);
  EXPECT_EQ(value("x^2.0", -3), 9);
  EXPECT_EQ(value("x^(-3)", -2), -0.125);
  EXPECT_EQ(value("x^999999", -1), -1);
  EXPECT_EQ(value("x^1000001", -1), -1);  // by pow
  EXPECT_EQ(value("2^10*2^(5+5)"), 1048576);
  const auto whole = [](const char* text) {
    return parse_expression(text).value().nodes().back().whole_exponent;
  };
  EXPECT_EQ(whole("x^-3"), -3);
  EXPECT_FALSE(whole("x^(1+1)").has_value());
  EXPECT_FALSE(whole("x^0.5").has_value());
  EXPECT_FALSE(whole("x^1e6").has_value());
  EXPECT_FALSE(whole("x^-1e6").has_value());
  EXPECT_EQ(whole("x^-999999"), -999999);
  EXPECT_FALSE(whole("x^y").has_value());
}

}  // namespace

namespace other {

/// Text as an arithmetic: the value of an expression is the expression fully in parentheses.
struct Written {
  std::string text;
  Written(std::string written) : text(std::move(written)) {}
  Written(int number) : text(std::to_string(number)) {}
};
Written operator+(const Written& a, const Written& b) { return {"(" + a.text + "+" + b.text + ")"}; }
Written operator-(const Written& a, const Written& b) { return {"(" + a.text + "-" + b.text + ")"}; }
Written operator*(const Written& a, const Written& b) { return {"(" + a.text + "*" + b.text + ")"}; }
Written operator/(const Written& a, const Written& b) { return {"(" + a.text + "/" + b.text + ")"}; }
Written operator-(const Written& a) { return {"(-" + a.text + ")"}; }
Written pow(const Written& a, const Written& b) { return {"(" + a.text + "^" + b.text + ")"}; }
Written power(const Written& a, long n) { return {"(" + a.text + "^" + std::to_string(n) + ")"}; }
Written sqrt(const Written& a) { return {"sqrt(" + a.text + ")"}; }
Written exp(const Written& a) { return {"exp(" + a.text + ")"}; }
Written log(const Written& a) { return {"log(" + a.text + ")"}; }
Written sin(const Written& a) { return {"sin(" + a.text + ")"}; }
Written cos(const Written& a) { return {"cos(" + a.text + ")"}; }
Written tan(const Written& a) { return {"tan(" + a.text + ")"}; }
Written atan(const Written& a) { return {"atan(" + a.text + ")"}; }
Written abs(const Written& a) { return {"abs(" + a.text + ")"}; }
Written min(const Written& a, const Written& b) { return {"min(" + a.text + "," + b.text + ")"}; }
Written max(const Written& a, const Written& b) { return {"max(" + a.text + "," + b.text + ")"}; }

}  // namespace other

template <>
struct radcert::Constants<other::Written> {
  static other::Written from_rational(const Rational& q) { return {q.to_text()}; }
  static other::Written pi() { return {"pi"}; }
};

namespace {

TEST(EvaluateExpression, WorksInAnyArithmetic) {
  const auto written = [](const char* text) {
    return parse_expression(text)
        .value()
        .evaluate<other::Written>({std::string("x"), std::string("y"), std::string("z")})
        .text;
  };
  EXPECT_EQ(written("-2^2"), "(-(2^2))");
  EXPECT_EQ(written("1-2-3"), "((1-2)-3)");
  EXPECT_EQ(written("x/y/z"), "((x/y)/z)");
  EXPECT_EQ(written("2^3^x"), "(2^(3^x))");
  EXPECT_EQ(written("-x*y"), "((-x)*y)");
  EXPECT_EQ(written("x*-y^-z"), "(x*(-(y^(-z))))");
  EXPECT_EQ(written("0.1+pi"), "(1/10+pi)");
  EXPECT_EQ(written("sqrt(exp(log(sin(cos(tan(atan(abs(x))))))))"),
            "sqrt(exp(log(sin(cos(tan(atan(abs(x))))))))");
  EXPECT_EQ(written("min(x,max(y,z))"), "min(x,max(y,z))");
}

TEST(Expression, IsTheConstantZeroByDefault) {
  EXPECT_EQ(Expression().evaluate<double>({1, 2, 3}), 0);
  EXPECT_EQ(Expression().is_constant(), Rational(0));
  EXPECT_EQ(Expression::constant(Rational(1, 3)).text(), "1/3");
  EXPECT_EQ(Expression::constant(Rational(1, 3), "a third").text(), "a third");
}

TEST(Expression, FindsWholeExponentsItself) {
  // A node that claims an exponent which the tree does not have.
  const ExpressionNode leaf{.kind = ExpressionKind::pi};
  const Expression expression(
      {leaf, leaf, {.kind = ExpressionKind::power, .left = 0, .right = 1, .whole_exponent = 2}}, "pi^pi",
      ExpressionVariables::space);
  EXPECT_FALSE(expression.nodes().back().whole_exponent.has_value());
}

TEST(Expression, CopiesShareTheTree) {
  const Expression one = parse_expression("x+1").value();
  const Expression two = one;
  EXPECT_EQ(&one.nodes(), &two.nodes());
}

TEST(Expression, RefusesWhatIsNotATree) {
  const auto make = [](std::vector<ExpressionNode> nodes) {
    return Expression(std::move(nodes), "", ExpressionVariables::space);
  };
  const ExpressionNode leaf{.kind = ExpressionKind::pi};
  EXPECT_NO_THROW((void)make({leaf, leaf, {.kind = ExpressionKind::add, .left = 0, .right = 1}}));
  EXPECT_THROW((void)make({}), radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, leaf}), radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, leaf, {.kind = ExpressionKind::add, .left = 1, .right = 0}}),
               radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, {.kind = ExpressionKind::add, .left = 0, .right = 0}}),
               radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, {.kind = ExpressionKind::sin, .left = 1}}), radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, {.kind = ExpressionKind::sin, .left = 7}}), radcert::ContractViolation);
  EXPECT_THROW((void)make({leaf, {.kind = ExpressionKind::sin, .left = 0, .right = 0}}),
               radcert::ContractViolation);
  EXPECT_THROW((void)make({{.kind = ExpressionKind::variable, .variable = 3}}), radcert::ContractViolation);
  EXPECT_THROW((void)make({{.kind = ExpressionKind::variable}}), radcert::ContractViolation);
}

}  // namespace
