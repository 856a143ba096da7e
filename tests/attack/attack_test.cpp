// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/attack/attack.h"

#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace radcert::attack {
namespace {

// The frame itself: it finds a violation among many instances, shows the smallest, and counts refusals.
TEST(Attack, ShowsTheSmallestInstanceThatViolates) {
  const Attack<int> attack{
      .name = "numbers below 1000",
      .usual_instances = 50,
      .make = [](Draw& draw) { return static_cast<int>(draw.below(1000)); },
      .judge =
          [](int n) {
            if (n % 2 == 1) return Judgement::refused();
            return n >= 100 ? Judgement::violated("not below 100") : Judgement::held();
          },
      .text = [](int n) { return "n = " + std::to_string(n); },
      .smaller =
          [](int n) {
            return std::vector<int>{n / 2, n - 1, n - 2};
          },
  };
  testing::TestPartResultArray failures;
  Count count;
  {
    const testing::ScopedFakeTestPartResultReporter caught(&failures);
    count = hold(attack);
  }
  ASSERT_EQ(failures.size(), 10);
  for (int k = 0; k < failures.size(); ++k)
    EXPECT_THAT(failures.GetTestPartResult(k).message(), testing::HasSubstr("n = 100"));
  EXPECT_GT(count.refused, 10U);
  EXPECT_GT(count.violated, 10U);
}

TEST(Attack, TakesAnExceptionForAViolation) {
  const Attack<int> attack{
      .name = "throws",
      .usual_instances = 1,
      .make = [](Draw&) { return 0; },
      .judge = [](int) -> Judgement { throw std::runtime_error("broken"); },
      .text = [](int) { return std::string(); },
  };
  testing::TestPartResultArray failures;
  {
    const testing::ScopedFakeTestPartResultReporter caught(&failures);
    EXPECT_EQ(hold(attack).violated, 1U);
  }
  ASSERT_EQ(failures.size(), 1);
  EXPECT_THAT(failures.GetTestPartResult(0).message(), testing::HasSubstr("not foreseen: broken"));
}

}  // namespace
}  // namespace radcert::attack
