// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/ball_precision.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/ball.h"

namespace radcert {
namespace {

/// The bits that one rounding leaves: 1/3 has no end in binary.
long bits_of_a_third() { return Ball(Rational(1, 3)).accurate_bits(); }

void expect_precision(long bits) {
  EXPECT_EQ(BallPrecision::current(), bits);
  EXPECT_NEAR(static_cast<double>(bits_of_a_third()), static_cast<double>(bits), 2);
}

TEST(BallPrecision, IsThatOfTheInnermostScope) {
  expect_precision(BallPrecision::default_bits);
  {
    const BallPrecision outer(64);
    expect_precision(64);
    {
      const BallPrecision inner(1000);
      expect_precision(1000);
    }
    expect_precision(64);
    EXPECT_THROW(
        {
          const BallPrecision inner(300);
          throw std::string("out of the scope");
        },
        std::string);
    expect_precision(64);
  }
  expect_precision(BallPrecision::default_bits);
}

TEST(BallPrecision, RefusesWithTheNumber) {
  for (const long bits : {-1L, 0L, 1L, 1000001L}) {
    try {
      const BallPrecision precision(bits);
      ADD_FAILURE() << bits;
    } catch (const ContractViolation& error) {
      EXPECT_NE(std::string(error.what()).find(std::to_string(bits)), std::string::npos) << error.what();
    }
    EXPECT_EQ(BallPrecision::current(), BallPrecision::default_bits);
  }
  for (const long bits : {2L, 1000000L}) {
    const BallPrecision precision(bits);
    EXPECT_EQ(BallPrecision::current(), bits);
  }
}

TEST(BallPrecision, IsOfItsThread) {
  const BallPrecision here(80);
  constexpr int threads = 8;
  std::array<bool, threads> right{};
  std::vector<std::thread> workers;
  for (int i = 0; i < threads; ++i)
    workers.emplace_back([&right, i] {
      bool all = BallPrecision::current() == BallPrecision::default_bits;
      for (int round = 0; round < 200; ++round) {
        const long bits = 100 + 50 * i + round;
        const BallPrecision precision(bits);
        // pi, log and exp keep constants for each thread.
        const Ball one = exp(log(pi<Ball>())) / pi<Ball>();
        all = all && BallPrecision::current() == bits && one.contains(1.0) &&
              one.accurate_bits() > bits - 8 && one.accurate_bits() < bits + 2;
      }
      right[static_cast<std::size_t>(i)] = all;
    });
  for (std::thread& worker : workers) worker.join();
  for (int i = 0; i < threads; ++i) EXPECT_TRUE(right[static_cast<std::size_t>(i)]) << i;
  expect_precision(80);
}

TEST(BallPrecision, IsCarriedIntoAParallelLoopByWhoeverStartsIt) {
  const BallPrecision precision(200);
  const long bits = BallPrecision::current();
  const Ball sum = parallel_reduce_ordered(
      1000, 10, Ball(),
      [bits](std::size_t begin, std::size_t end) {
        const BallPrecision inside(bits);
        Ball part;
        for (std::size_t k = begin; k < end; ++k)
          part += Ball(Rational(1, static_cast<long>((k + 1) * (k + 2))));
        return part;
      },
      [](const Ball& a, const Ball& b) { return a + b; });
  EXPECT_TRUE(sum.contains(Rational(1000, 1001)));
  EXPECT_GT(sum.accurate_bits(), 185);
}

TEST(BallPrecision, LeavesABallItsDigitsInAnotherThread) {
  const BallPrecision precision(500);
  Ball third;
  std::thread([&third] {
    const BallPrecision inside(500);
    third = Ball(Rational(1, 3));
  }).join();
  EXPECT_TRUE(third.contains(Rational(1, 3)));
  EXPECT_GT(third.accurate_bits(), 490);
}

}  // namespace
}  // namespace radcert
