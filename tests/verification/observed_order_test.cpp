// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/observed_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "radcert/core/contract.h"

namespace radcert::verification {
namespace {

LevelErrors made_up(const std::function<double(double)>& error, int first, int last, double radius = 0) {
  LevelErrors errors;
  for (int level = first; level <= last; ++level) {
    const double h = std::ldexp(1.0, -level);
    errors.mesh_sizes.push_back(h);
    errors.errors.push_back({.value = error(h), .radius = radius * error(h)});
  }
  return errors;
}

bool holds(const ObservedOrder& order, double p) {
  return std::abs(order.exponent.value - p) <= order.exponent.radius;
}

TEST(ObservedOrder, OfAPowerIsItsExponent) {
  for (const double p : {0.5, 1.0, 2.0, 3.75}) {
    const ObservedOrder order = observed_order(made_up([p](double h) { return 5 * std::pow(h, p); }, 0, 3));
    EXPECT_NEAR(order.exponent.value, p, 1e-12);
    EXPECT_LT(order.exponent.radius, 1e-12);
    EXPECT_EQ(order.logarithm, 0);
  }
}

// With h^p (1 + c h^q), q >= next, the distance to p shrinks by 2^next at least, as long as c h is small.
TEST(ObservedOrder, HoldsTheExponentOfAPowerWithItsNextTerm) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double p = 1 + 5 * uniform(random);
    const double next = 0.25 + 0.75 * uniform(random);
    const double q = next * (1.25 + uniform(random));
    const double c = (uniform(random) - 0.5) / 5;
    const int last = 2 + static_cast<int>(4 * uniform(random));
    const auto error = [&](double h) { return std::pow(h, p) * (1 + c * std::pow(h, q)); };
    EXPECT_TRUE(holds(observed_order(made_up(error, 0, last), {.next = next}), p))
        << p << " " << next << " " << q << " " << c << " " << last;
  }
}

TEST(ObservedOrder, HoldsTheOrdersOfAllErrorsWithinTheirRadii) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const LevelErrors errors = made_up([](double h) { return h * h * (1 + h / 4); }, 1, 4, 0.1);
  const ObservedOrder order = observed_order(errors);
  for (int trial = 0; trial < 200; ++trial) {
    LevelErrors other = errors;
    for (Approximation& each : other.errors) {
      each.value += each.radius * uniform(random);
      each.radius = 0;
    }
    EXPECT_LE(std::abs(observed_order(other).exponent.value - order.exponent.value), order.exponent.radius);
  }
}

TEST(ObservedOrder, TakesALogarithmOut) {
  const auto error = [](double h) { return std::pow(h, 4) * std::abs(std::log(h)); };
  const ObservedOrder order = observed_order(made_up(error, 1, 4), {.logarithm = true});
  EXPECT_NEAR(order.exponent.value, 4, 1e-12);
  EXPECT_LT(order.exponent.radius, 1e-11);
  EXPECT_NEAR(order.logarithm, std::log2(4.0 / 3), 1e-12);
  // h = 1 and more have no logarithm to speak of.
  EXPECT_EQ(observed_order(made_up(error, -1, 4), {.logarithm = true}).exponent.radius,
            order.exponent.radius);
  // An error without it is faster.
  const auto power = [](double h) { return std::pow(h, 4); };
  const ObservedOrder faster = observed_order(made_up(power, 2, 5), {.logarithm = true});
  EXPECT_GT(faster.exponent.value - faster.exponent.radius, 4);
}

TEST(ObservedOrder, IsWideWhereOrdersOscillateAndWhereTwoAgreeByChance) {
  LevelErrors errors{.mesh_sizes = {1, 0.5, 0.25, 0.125}, .errors = {}};
  for (const double exponent : {0.0, 0.0, 3.0, 5.0}) errors.errors.push_back({std::exp2(-exponent), 0});
  // 0, 3, 2.
  EXPECT_NEAR(observed_order(errors).exponent.value, 2, 1e-12);
  EXPECT_NEAR(observed_order(errors).exponent.radius, 1.5, 1e-12);
  // 0, 3, 3.
  errors.errors.back() = {std::exp2(-6.0), 0};
  EXPECT_NEAR(observed_order(errors).exponent.radius, 1.5, 1e-12);
}

TEST(ObservedOrder, IsUnknownWhereAnErrorIsWithinItsRadius) {
  for (const double radius : {1.0, 2.0})
    EXPECT_FALSE(
        std::isfinite(observed_order(made_up([](double h) { return h; }, 0, 3, radius)).exponent.radius));
  EXPECT_FALSE(exponent_between({.value = 1, .radius = 0}, {.value = 0, .radius = 0}).has_radius());
}

TEST(ObservedOrder, TakesThreeLevels) {
  const auto power = [](double h) { return h; };
  EXPECT_THROW(static_cast<void>(observed_order(made_up(power, 0, 1))), ContractViolation);
  EXPECT_THROW(static_cast<void>(observed_order(made_up(power, 0, 2), {.logarithm = true})),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(observed_order(made_up(power, 0, 2), {.next = 0})), ContractViolation);
}

TEST(ExponentBetween, HoldsThoseOfAllErrorsWithinTheirRadii) {
  const Approximation coarse{.value = 16, .radius = 2};
  const Approximation fine{.value = 1, .radius = 0.5};
  const Approximation order = exponent_between(coarse, fine, 4);
  EXPECT_DOUBLE_EQ(order.value, 2);
  for (const double before : {14.0, 16.0, 18.0})
    for (const double after : {0.5, 1.0, 1.5})
      EXPECT_LE(std::abs(std::log(before / after) / std::log(4.0) - order.value), order.radius);
  EXPECT_FALSE(order.guaranteed);
}

}  // namespace
}  // namespace radcert::verification
