// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace radcert {
namespace {

TEST(LevelPlan, HoldsTheMatrixAndItsFactors) {
  for (const std::uint64_t elements : {std::uint64_t{48}, std::uint64_t{1} << 14U}) {
    const std::uint64_t unknowns = 3 * elements;
    const std::uint64_t matrices = 2 * unknowns * unknowns * sizeof(double);
    EXPECT_GE(level_plan(elements, 3).total(), matrices);
    EXPECT_LE(level_plan(elements, 3).total(), matrices + unknowns * 2000);
  }
}

TEST(LevelPlan, GrowsSixteenfoldALevel) {
  for (std::uint64_t elements = 1U << 12U; elements < 1U << 20U; elements *= 4) {
    const double ratio = static_cast<double>(level_plan(4 * elements, 6).total()) /
                         static_cast<double>(level_plan(elements, 6).total());
    EXPECT_GT(ratio, 15.9);
    EXPECT_LT(ratio, 16);
  }
}

TEST(LevelPlan, SaysAllBitsForMoreThanFits) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t elements : {std::uint64_t{1} << 40U, std::uint64_t{1} << 53U, all})
    EXPECT_EQ(level_plan(elements, 45).total(), all);
}

}  // namespace
}  // namespace radcert
