// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/decimal.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

Rational value_of(const BinaryNumber& number) {
  const Rational mantissa = Rational::parse(number.mantissa).value();
  return mantissa * power(Rational(2), std::stol(number.exponent));
}

/// The ends, exactly.
struct Ends {
  Rational low;
  Rational high;
};

Ends ends_of(const Ball& ball) {
  const Rational midpoint = value_of(ball.midpoint_binary());
  const Rational radius = value_of(ball.radius_binary());
  return {midpoint - radius, midpoint + radius};
}

/// A ball of moderate size: decimals of Rational end at 10^+-400.
Ball some_ball(Draw& draw) {
  const Draw::Interval x = draw.interval();
  const Ball ball = hull(Ball(x.low), Ball(x.high));
  switch (draw.below(3)) {
    case 0: return ball;
    case 1: return ball / 3;
    default: return ball * pi<Ball>();
  }
}

TEST(BallText, PrintedBallEncloses) {
  Draw draw(21);
  for (int trial = 0; trial < 5000; ++trial) {
    const Ball ball = some_ball(draw);
    const int digits = 1 + static_cast<int>(draw.below(60));
    const BallDecimal text = ball.decimal(digits);
    SCOPED_TRACE(text.midpoint + " +/- " + text.radius + ", " + std::to_string(digits) + " digits");
    const Rational midpoint = Rational::parse(text.midpoint).value();
    const Rational radius = Rational::parse(text.radius).value();
    const Ends ends = ends_of(ball);
    ASSERT_LE(midpoint - radius, ends.low);
    ASSERT_GE(midpoint + radius, ends.high);
    // No wider than the digits asked for make it: half a unit of the last printed place, and the radius
    // rounded up.
    const Rational unit = abs(midpoint) * power(Rational(10), 1 - digits);
    ASSERT_LE(radius, Rational(11, 10) * (ends.high - ends.low) / Rational(2) + unit);
  }
}

TEST(BallText, ParseGivesABallAroundThePrintedOne) {
  Draw draw(22);
  for (int trial = 0; trial < 3000; ++trial) {
    const Ball ball = some_ball(draw);
    const std::string text = ball.to_text(1 + static_cast<int>(draw.below(60)));
    ASSERT_TRUE(Ball::parse(text).value().contains(ball)) << text;
    ASSERT_TRUE(Ball::parse("[" + text + "]").value().contains(ball)) << text;
  }
  const Ball huge = exp(Ball(1000000));
  EXPECT_TRUE(Ball::parse(huge.to_text()).value().contains(huge)) << huge.to_text();
}

TEST(BallText, BinaryIsTheBallItself) {
  Draw draw(23);
  for (int trial = 0; trial < 3000; ++trial) {
    const Ball ball = some_ball(draw);
    const Ball again = Ball::from_binary(ball.midpoint_binary(), ball.radius_binary()).value();
    ASSERT_TRUE(again.contains(ball) && ball.contains(again)) << ball.to_text(50);
    const Ends ends = ends_of(ball);
    ASSERT_TRUE(ball.contains(ends.low) && ball.contains(ends.high));
    const Rational outside = (ends.high - ends.low) / Rational(1000000);
    if (outside.sign() > 0) {
      ASSERT_FALSE(ball.contains(ends.high + outside) || ball.contains(ends.low - outside));
    }
  }
  // A radius of more than 30 bits is rounded up.
  const Ball rounded = Ball::from_binary({"0", "0"}, {"1234567890123456789", "-70"}).value();
  EXPECT_TRUE(rounded.contains(Rational(1234567890123456789) * power(Rational(2), -70)));
}

TEST(BallText, ParseEnclosesWhatTheTextSays) {
  EXPECT_TRUE(Ball::parse("0.1").value().contains(Rational(1, 10)));
  EXPECT_FALSE(Ball::parse("0.1").value().is_exact());
  EXPECT_TRUE(Ball::parse("0.5").value().is_exact());
  EXPECT_TRUE(Ball::parse("-1/3").value().contains(Rational(-1, 3)));
  EXPECT_TRUE(Ball::parse("1e-400").value().contains(Rational::parse("1e-400").value()));
  EXPECT_TRUE(Ball::parse("1e1000").value().contains(power(Rational(10), 1000)));
  const Ball ball = Ball::parse("0.1 +/- 1e-3").value();
  EXPECT_TRUE(ball.contains(Rational(101, 1000)) && ball.contains(Rational(99, 1000)));
  EXPECT_FALSE(ball.contains(Rational(10101, 100000)));
  EXPECT_TRUE(Ball::parse("[-2/3 +/- 1/7]").value().contains(Rational(-11, 21)));
  const Ball to_zero = Ball::parse("0.5 +/- 0.5").value();
  EXPECT_TRUE(sqrt(to_zero).is_finite());
  for (const char* text : {"",
                           "x",
                           "0.1 +/-",
                           "0.1 +/- ",
                           "+/- 1",
                           "0.1 +/- -1",
                           "0.1+/-0.2",
                           "[0.1",
                           "0.1]",
                           "1e",
                           "nan",
                           "inf",
                           "-inf",
                           "1,5",
                           "0x1p3",
                           "1e9999999999999999999",
                           "1/0",
                           "0.1 +/- inf",
                           "1 2",
                           " 1",
                           "1 +/- 2 +/- 3"})
    EXPECT_FALSE(Ball::parse(text).has_value()) << text;
}

TEST(BallText, FromBinaryRefuses) {
  for (const char* bad : {"", "-", "1.5", "x", " 1", "1e3", "--1", "+1"}) {
    EXPECT_FALSE(Ball::from_binary({bad, "0"}, {"0", "0"}).has_value()) << bad;
    EXPECT_FALSE(Ball::from_binary({"1", bad}, {"0", "0"}).has_value()) << bad;
    EXPECT_FALSE(Ball::from_binary({"1", "0"}, {bad, "0"}).has_value()) << bad;
    EXPECT_FALSE(Ball::from_binary({"1", "0"}, {"1", bad}).has_value()) << bad;
  }
  EXPECT_FALSE(Ball::from_binary({"1", "0"}, {"-1", "0"}).has_value());
}

TEST(BallText, ExactNumbersHaveNoRadius) {
  EXPECT_EQ(Ball(1000000).to_text(), "1000000");
  EXPECT_EQ(Ball(0).to_text(), "0");
  EXPECT_EQ(Ball(-0.375).to_text(), "-0.375");
  EXPECT_EQ(Ball(3).decimal(5).radius, "0");
  EXPECT_THROW((void)Ball(1).decimal(0), ContractViolation);
  // 0.1 as a double has 55 decimals: with fewer digits the rounding shows as a radius.
  EXPECT_NE(Ball(0.1).decimal(20).radius, "0");
  EXPECT_EQ(Ball(0.1).decimal(60).radius, "0");
}

TEST(BallText, ShowsTheDigitsThatMeanSomething) {
  const BallDecimal text = widened(pi<Ball>(), Ball(1e-6)).decimal(50);
  EXPECT_GE(text.midpoint.size(), 8U);
  EXPECT_LE(text.midpoint.size(), 12U) << text.midpoint;
}

TEST(Decimal, IsOneNumber) {
  for (const char* text :
       {"0", "-1", "+2", "1.5", ".5", "2.", "1e5", "-1.5E-10", "1e+3", "007", "1e123456789012345678"})
    EXPECT_TRUE(is_decimal(text)) << text;
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "--1", "1 ", " 1", "1e1234567890123456789", "1/2", "inf"})
    EXPECT_FALSE(is_decimal(text)) << text;
}

}  // namespace
}  // namespace radcert
