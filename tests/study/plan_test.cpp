// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "radcert/solve/estimated_contraction.h"
#include "radcert/study/collocation/collocation.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::sample_problem;
using testing::with_basis;

std::uint64_t planned(std::uint64_t elements, int degree, const std::string& solver) {
  Problem problem = with_basis(sample_problem("cube"), degree, Rational(1, 6));
  problem.solver.name = solver;
  problem.matrix.name = "dense";
  return level_plan(problem, elements).total();
}

TEST(LevelPlan, HoldsTheMatrixAndWhatItsSolverAddsToIt) {
  for (const std::uint64_t elements : {std::uint64_t{48}, std::uint64_t{1} << 14U}) {
    const std::uint64_t unknowns = 3 * elements;
    const std::uint64_t matrix = unknowns * unknowns * sizeof(double);
    const auto total = [&](const char* solver) { return planned(elements, 1, solver); };
    EXPECT_GE(total("direct"), 2 * matrix);
    EXPECT_LE(total("direct"), 2 * matrix + unknowns * 2000);
    EXPECT_EQ(total("neumann"), total("direct") - matrix);
    EXPECT_EQ(total("verified"), total("neumann") + 4 * matrix);
    EXPECT_EQ(total("gmres"), total("neumann") + unknowns * 65 * sizeof(double));
    EXPECT_EQ(total("auto"), total("gmres"));
  }
}

TEST(LevelPlan, GrowsSixteenfoldALevel) {
  for (const std::string& solver : solver_names())
    for (std::uint64_t elements = 1U << 12U; elements < 1U << 20U; elements *= 4) {
      const double ratio = static_cast<double>(planned(4 * elements, 2, solver)) /
                           static_cast<double>(planned(elements, 2, solver));
      // The coarser level of an estimate does not grow.
      EXPECT_GT(ratio, solver == gmres_by_estimate ? 15 : 15.8);
      EXPECT_LT(ratio, 16);
    }
}

TEST(LevelPlan, SaysAllBitsForMoreThanFits) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  for (const std::string& solver : solver_names())
    for (const std::uint64_t elements : {std::uint64_t{1} << 40U, std::uint64_t{1} << 53U, all})
      EXPECT_EQ(planned(elements, 8, solver), all);
}

}  // namespace
}  // namespace radcert
