// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/approximation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(Approximation, SumsEncloseAndBallsGoInAndOut) {
  const Approximation third = enclosing(Ball(Rational(1, 3)));
  Approximation sum = Approximation::exact(0);
  for (int k = 0; k < 3000; ++k) sum += third;
  EXPECT_TRUE(ball_of(sum).contains(Rational(1000)));
  EXPECT_LE(sum.radius, 1e-9);
  EXPECT_TRUE(sum.guaranteed);
  EXPECT_TRUE(ball_of(third).contains(Rational(1, 3)));
  EXPECT_THROW(static_cast<void>(enclosing(Ball(1) / Ball(0))), ContractViolation);
}

TEST(Approximation, OfASumHasAtLeastTheSumOfTheRadiiAndItsRounding) {
  std::mt19937_64 random(10);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
  for (int trial = 0; trial < 400; ++trial) {
    // Values from 0, where the radii alone are rounded, to those beside which radii are nothing.
    const double size = trial % 4 == 0 ? 0 : std::ldexp(1.0, static_cast<int>(random() % 100) - 50);
    const Approximation a = Approximation::proved(size * unit(), unit());
    const Approximation b = Approximation::proved(-size * unit(), unit());
    const Approximation sum = a + b;
    const Rational rounded =
        abs(Rational::exactly(a.value) + Rational::exactly(b.value) - Rational::exactly(sum.value));
    const Rational least = Rational::exactly(a.radius) + Rational::exactly(b.radius) + rounded;
    EXPECT_GE(Rational::exactly(sum.radius), least)
        << a.value << " " << a.radius << " " << b.value << " " << b.radius;
    EXPECT_LE(sum.radius, (a.radius + b.radius + 0x1p-53 * std::abs(sum.value)) * (1 + 1e-14));
  }
}

TEST(Approximation, KnowsNothingOfItsErrorUnlessItIsTold) {
  const Approximation unknown;
  EXPECT_FALSE(unknown.has_radius());
  EXPECT_FALSE(unknown.guaranteed);
  EXPECT_FALSE(Approximation::without_radius(1).has_radius());
  EXPECT_FALSE((Approximation::exact(1) + unknown).has_radius());
  const Approximation not_a_number{1, std::nan(""), true};
  EXPECT_FALSE(not_a_number.has_radius());
}

TEST(Approximation, IsProvedOnlyWhereAllOfItIs) {
  const Approximation proved = Approximation::proved(2, 1e-3);
  const Approximation estimated = Approximation::estimated(3, 1e-3);
  EXPECT_TRUE((proved + Approximation::exact(1)).guaranteed);
  EXPECT_TRUE((-proved).guaranteed);
  EXPECT_EQ((-proved).radius, proved.radius);
  EXPECT_FALSE((proved + estimated).guaranteed);
  EXPECT_FALSE((estimated + proved).guaranteed);
  EXPECT_TRUE(max_abs(std::vector{proved, -proved}).guaranteed);
  EXPECT_FALSE(max_abs(std::vector{proved, estimated}).guaranteed);
}

TEST(Approximation, HoldsTheBallAndTheLargestAbsoluteValue) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Approximation> numbers;
    double most = 0;
    double least = 0;
    for (int i = 0; i < 5; ++i) {
      const Rational middle = Rational(static_cast<long>(random() % 2001) - 1000) / 997;
      const double radius = random() % 3 == 0 ? 0.0 : std::ldexp(1.0, -static_cast<int>(random() % 70));
      const Ball ball = widened(Ball(middle), Ball(radius));
      numbers.push_back(enclosing(ball));
      EXPECT_TRUE(ball_of(numbers.back()).contains(ball));
      EXPECT_LE(numbers.back().radius, radius * (1 + 1e-8) + 2.3e-16);
      most = std::max(most, std::abs(numbers.back().value) + numbers.back().radius);
      least = std::max(least, std::abs(numbers.back().value) - numbers.back().radius);
    }
    const Approximation largest = max_abs(numbers);
    EXPECT_TRUE(largest.guaranteed);
    EXPECT_GE(largest.value + largest.radius, most * (1 - 1e-15));
    EXPECT_LE(largest.value - largest.radius, least * (1 + 1e-15));
    EXPECT_LE(2 * largest.radius, (most - least) * (1 + 1e-8) + 1e-15);
  }
}

}  // namespace
}  // namespace radcert
