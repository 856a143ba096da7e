// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/batch.h"

#include "radcert/expression/parse.h"
#include "radcert/scalar/pack.h"
#include "tests/expression/random_expression.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using radcert::CompiledExpression, radcert::Expression, radcert::parse_expression;

/// Equal bits; one NaN is as good as another, since which one an operation passes on is the machine's affair.
bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(CompiledExpression, GivesTheBitsOfTheScalarEvaluation) {
  std::mt19937_64 random(21);
  static constexpr double corners[] = {0.0,
                                       -0.0,
                                       1.0,
                                       -1.0,
                                       0.5,
                                       1e300,
                                       1e-300,
                                       5e-324,
                                       std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::quiet_NaN()};
  const auto coordinate = [&] {
    return random() % 4 == 0 ? corners[random() % std::size(corners)]
                             : 4 * (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5);
  };
  for (int trial = 0; trial < 1500; ++trial) {
    const std::string text = radcert::test::random_expression(random, 6);
    SCOPED_TRACE(text);
    const auto parsed = parse_expression(text);
    ASSERT_TRUE(parsed.has_value()) << parsed.reason().to_text();
    const std::size_t count = random() % 200;
    std::vector<double> x(count);
    std::vector<double> y(count);
    std::vector<double> z(count);
    std::vector<double> out(count);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = coordinate();
      y[i] = coordinate();
      z[i] = coordinate();
    }
    CompiledExpression(*parsed).evaluate(x, y, z, out);
    for (std::size_t i = 0; i < count; ++i) {
      const double alone = parsed->evaluate<double>({x[i], y[i], z[i]});
      ASSERT_TRUE(same(out[i], alone))
          << "at (" << x[i] << ", " << y[i] << ", " << z[i] << "): " << out[i] << " and " << alone;
    }
  }
}

TEST(Expression, GivesInPacksTheBitsOfDouble) {
  std::mt19937_64 random(22);
  const auto coordinate = [&] { return 4 * (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5); };
  for (int trial = 0; trial < 300; ++trial) {
    const auto parsed = parse_expression(radcert::test::random_expression(random, 6));
    ASSERT_TRUE(parsed.has_value());
    radcert::Variables<radcert::Pack> at{0.0, 0.0, 0.0};
    for (std::size_t lane = 0; lane < radcert::Pack::lanes; ++lane) {
      at.x.set_lane(lane, lane == 3 ? std::numeric_limits<double>::quiet_NaN() : coordinate());
      at.y.set_lane(lane, coordinate());
      at.z.set_lane(lane, lane == 5 ? -0.0 : coordinate());
    }
    const radcert::Pack values = parsed->evaluate<radcert::Pack>(at);
    for (std::size_t lane = 0; lane < radcert::Pack::lanes; ++lane)
      ASSERT_TRUE(same(values.lane(lane),
                       parsed->evaluate<double>({at.x.lane(lane), at.y.lane(lane), at.z.lane(lane)})))
          << parsed->text() << " in lane " << lane;
  }
}

TEST(CompiledExpression, WritesEveryResultAndNoOther) {
  const CompiledExpression sum(parse_expression("x+y+z").value());
  for (const std::size_t count : {0UL, 1UL, 63UL, 64UL, 65UL, 128UL, 1000UL}) {
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i) x[i] = static_cast<double>(i);
    std::vector<double> guarded(count + 2, -7.0);
    sum.evaluate(x, x, x, std::span(guarded).subspan(1, count));
    EXPECT_EQ(guarded.front(), -7);
    EXPECT_EQ(guarded.back(), -7);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(guarded[i + 1], 3 * static_cast<double>(i)) << count;
  }
}

TEST(CompiledExpression, TakesFunctionsOfTheRadius) {
  const Expression expression =
      parse_expression("max(0, 1-r)^2 + r^-2^1", radcert::ExpressionVariables::radius).value();
  const std::vector<double> r{0.25, 1, 3};
  std::vector<double> out(3);
  CompiledExpression(expression).evaluate_radial(r, out);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(out[i], expression.evaluate_radial(r[i]));
  EXPECT_THROW(CompiledExpression(expression).evaluate(r, r, r, out), radcert::ContractViolation);
}

TEST(CompiledExpression, RefusesSpansOfDifferentLengths) {
  const CompiledExpression expression(parse_expression("x").value());
  const std::vector<double> three(3);
  const std::vector<double> two(2);
  std::vector<double> out(3);
  EXPECT_THROW(expression.evaluate(three, two, three, out), radcert::ContractViolation);
  EXPECT_THROW(expression.evaluate(two, two, two, out), radcert::ContractViolation);
  EXPECT_THROW(CompiledExpression(parse_expression("r", radcert::ExpressionVariables::radius).value())
                   .evaluate_radial(two, out),
               radcert::ContractViolation);
}

TEST(CompiledExpression, TakesTheLongestAdmittedTexts) {
  std::string sum = "x";
  std::string nested = "x";
  for (int i = 0; i < 2047; ++i) sum += "+1";
  for (int i = 0; i < 64; ++i) nested = "1+(" + nested + ")";
  const std::vector<double> x{0.5};
  std::vector<double> out(1);
  CompiledExpression(parse_expression(sum).value()).evaluate(x, x, x, out);
  EXPECT_EQ(out[0], 2047.5);
  CompiledExpression(parse_expression(nested).value()).evaluate(x, x, x, out);
  EXPECT_EQ(out[0], 64.5);
}

TEST(CompiledExpression, OnePointEqualsTheBatch) {
  for (const char* text :
       {"x", "-x^2 + y/z", "min(x, max(y, z)) - abs(x - z)", "exp(sin(x)*y)^z", "(x - y)^3/2^-z"}) {
    const CompiledExpression expression(parse_expression(text).value());
    const std::vector<double> x{0.25, -1.5, 3};
    const std::vector<double> y{2, 0.1, -7};
    const std::vector<double> z{1, 4, 0.5};
    std::vector<double> out(3);
    expression.evaluate(x, y, z, out);
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = expression.at(x[i], y[i], z[i]);
      EXPECT_TRUE(value == out[i] || (std::isnan(value) && std::isnan(out[i]))) << text << " at point " << i;
    }
  }
}

}  // namespace
