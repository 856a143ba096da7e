// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace radcert {
namespace {

constexpr SolverName all_solvers[] = {SolverName::direct, SolverName::gmres, SolverName::neumann,
                                      SolverName::verified};

TEST(LevelPlan, HoldsTheMatrixAndWhatItsSolverAddsToIt) {
  for (const std::uint64_t elements : {std::uint64_t{48}, std::uint64_t{1} << 14U}) {
    const std::uint64_t unknowns = 3 * elements;
    const std::uint64_t matrix = unknowns * unknowns * sizeof(double);
    const auto total = [&](SolverName solver) { return level_plan(elements, 3, solver).total(); };
    EXPECT_GE(total(SolverName::direct), 2 * matrix);
    EXPECT_LE(total(SolverName::direct), 2 * matrix + unknowns * 2000);
    EXPECT_EQ(total(SolverName::neumann), total(SolverName::direct) - matrix);
    EXPECT_EQ(total(SolverName::verified), total(SolverName::neumann) + 4 * matrix);
    EXPECT_EQ(total(SolverName::gmres), total(SolverName::neumann) + unknowns * 65 * sizeof(double));
  }
}

TEST(LevelPlan, GrowsSixteenfoldALevel) {
  for (const SolverName solver : all_solvers)
    for (std::uint64_t elements = 1U << 12U; elements < 1U << 20U; elements *= 4) {
      const double ratio = static_cast<double>(level_plan(4 * elements, 6, solver).total()) /
                           static_cast<double>(level_plan(elements, 6, solver).total());
      EXPECT_GT(ratio, 15.8);
      EXPECT_LT(ratio, 16);
    }
}

TEST(LevelPlan, SaysAllBitsForMoreThanFits) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  for (const SolverName solver : all_solvers)
    for (const std::uint64_t elements : {std::uint64_t{1} << 40U, std::uint64_t{1} << 53U, all})
      EXPECT_EQ(level_plan(elements, 45, solver).total(), all);
}

}  // namespace
}  // namespace radcert
