// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/interval_integral.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double thirty_digits = 1e-30;

/// The enclosure is narrow and around the value.
void expect_value(const Enclosure& found, const Ball& exact, double radius) {
  ASSERT_TRUE(found.has_value()) << found.reason().to_text();
  EXPECT_LE(found->value.radius(), radius);
  EXPECT_TRUE(overlaps(found->value, exact)) << found->value.to_text(40) << ", " << exact.to_text(40);
}

TEST(IntegralOnInterval, HasTheValuesOfKnownIntegrals) {
  const BallPrecision precision(160);
  const Demand demand{.radius = thirty_digits};
  expect_value(
      integral_on_interval(line_function([](const auto& x) { return sin(x); }), 0, Ball::pi(), demand), 2,
      thirty_digits);
  expect_value(integral_on_interval(line_function([]<class R>(const R& x) { return R(4) / (R(1) + x * x); }),
                                    0, 1, demand),
               Ball::pi(), thirty_digits);
  expect_value(
      integral_on_interval(line_function([](const auto& x) { return exp(-(x * x)); }), -10, 10, demand),
      sqrt(Ball::pi()), thirty_digits);
  expect_value(
      integral_on_interval(line_function([]<class R>(const R& x) { return R(1) / x; }), 1, 1024, demand),
      10 * log(Ball(2)), thirty_digits);
  expect_value(integral_on_interval(line_function([](const auto& x) { return power(x, 3); }), 2, -1, demand),
               Ball(Rational(-15, 4)), thirty_digits);
}

TEST(IntegralOnInterval, ReachesTheEndsOfRootsAndTheKinksOfAbs) {
  const BallPrecision precision(128);
  expect_value(
      integral_on_interval(line_function([](const auto& x) { return sqrt(x); }), 0, 1, {.radius = 1e-20}),
      Ball(Rational(2, 3)), 1e-20);
  expect_value(integral_on_interval(line_function([]<class R>(const R& x) { return abs(x - R(1) / R(3)); }),
                                    0, 1, {.radius = 1e-10}),
               Ball(Rational(5, 18)), 1e-10);
}

TEST(IntegralOnInterval, KeepsTheUncertaintyOfItsEnds) {
  const Ball end = hull(Ball(1), Ball(1.25));
  const Enclosure found =
      integral_on_interval(line_function([]<class R>(const R&) { return R(2); }), 0, end, {.radius = 1});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->value.contains(Rational(2)));
  EXPECT_TRUE(found->value.contains(Rational(5, 2)));
}

TEST(IntegralOnInterval, IsUndecidedOverAPole) {
  const Enclosure found =
      integral_on_interval(line_function([]<class R>(const R& x) { return R(1) / (x - R(1) / R(3)); }), 0, 1,
                           {.radius = 1e-3, .work_limit = 5000});
  ASSERT_FALSE(found.has_value());
  EXPECT_FALSE(found.reason().reached.is_finite());
  EXPECT_NE(found.reason().why.find("contains zero"), std::string::npos) << found.reason().why;
}

TEST(IntegralOnInterval, IsUndecidedWhereRoundingIsWiderThanTheDemand) {
  const BallPrecision precision(64);
  const Enclosure found = integral_on_interval(line_function([](const auto& x) { return exp(x); }), 0, 1,
                                               {.radius = 1e-25, .work_limit = 5000});
  ASSERT_FALSE(found.has_value());
  EXPECT_TRUE(overlaps(found.reason().reached, exp(Ball(1)) - 1));
}

TEST(IntegralOnInterval, StopsNearItsWorkLimitWithWhatWasReached) {
  const auto wild = line_function([]<class R>(const R& x) { return sin(R(1) / x); });
  const Enclosure found = integral_on_interval(wild, 0, 1, {.radius = 1e-10, .work_limit = 500});
  ASSERT_FALSE(found.has_value());
  EXPECT_LT(found.reason().evaluations, 1000);
}

TEST(IntegralOnInterval, PassesOnWhatTheFunctionThrows) {
  const auto throwing = line_function([]<class R>(const R& x) -> R {
    if (x.is_finite()) throw std::runtime_error("from the function");
    return x;
  });
  EXPECT_THROW(static_cast<void>(integral_on_interval(throwing, 0, 1, {.radius = 1})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(integral_on_interval(throwing, 0, 1, {.radius = 0})), ContractViolation);
}

}  // namespace
}  // namespace radcert
