// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/expected_seconds.h"

#include <gtest/gtest.h>

#include <array>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(ExpectedSeconds, FollowsThePowerThatTheLastLevelsShow) {
  ExpectedSeconds expected;
  EXPECT_EQ(expected.of(std::array{16.0}), 0);
  expected.finished(1, 2);
  EXPECT_NEAR(expected.of(std::array{16.0}), 16, 1e-12);  // 2 times 16^(3/4)
  expected.finished(16, 32);
  EXPECT_NEAR(expected.of(std::array{256.0, 16.0}), 512 + 32, 1e-9);
}

TEST(ExpectedSeconds, IsNotMisledByWhatEveryLevelTakes) {
  // Half a second a level and a millisecond a unit: by the work alone level 3 would seem to take 500 s.
  ExpectedSeconds expected;
  double work = 1;
  for (int level = 0; level < 3; ++level, work *= 16) expected.finished(work, 0.5 + 0.001 * work);
  const double truth = 0.5 + 0.001 * work;
  const double told = expected.of(std::array{work});
  EXPECT_GT(told, truth / 2);
  EXPECT_LT(told, truth * 2);
}

TEST(ExpectedSeconds, TakesTheMeanOfEqualWorks) {
  ExpectedSeconds expected;
  expected.finished(8, 1);
  expected.finished(8, 3);
  EXPECT_NEAR(expected.of(std::array{8.0, 8.0}), 4, 1e-14);
  EXPECT_THROW(expected.finished(0, 1), ContractViolation);
  EXPECT_THROW(expected.finished(1, -1), ContractViolation);
}

}  // namespace
}  // namespace radcert
