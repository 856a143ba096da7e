// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>

#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/study/study.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::sample_problem;
using testing::with_emission;

LevelResult level(int number, double discretisation_error, double node_error, double relative_radius = 1e-6) {
  LevelResult result;
  result.level = number;
  result.mesh_size = std::ldexp(1.0, -number);
  result.discretisation_error =
      Approximation{discretisation_error, relative_radius * discretisation_error, false};
  result.node_error = Approximation{node_error, relative_radius * node_error, false};
  return result;
}

/// Errors 3 h^2 and 5 h^4 on the levels first to last.
std::vector<LevelResult> powers(int first, int last) {
  std::vector<LevelResult> levels;
  for (int k = first; k <= last; ++k)
    levels.push_back(level(k, std::ldexp(3.0, -2 * k), std::ldexp(5.0, -4 * k)));
  return levels;
}

TEST(Collect, FindsTheRatiosAndOrdersOfPowers) {
  const Result result = collect(sample_problem("sphere"), powers(0, 4), {});
  ASSERT_EQ(result.levels.size(), 5U);
  EXPECT_EQ(result.levels[0].discretisation_ratio, std::nullopt);
  EXPECT_EQ(result.levels[0].node_ratio, std::nullopt);
  EXPECT_EQ(result.levels[0].discretisation_order, std::nullopt);
  EXPECT_EQ(result.levels[0].node_order, std::nullopt);
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_EQ(result.levels[k].discretisation_ratio, 4);
    EXPECT_EQ(result.levels[k].node_ratio, 16);
    EXPECT_DOUBLE_EQ(result.levels[k].discretisation_order.value(), 2);
    EXPECT_DOUBLE_EQ(result.levels[k].node_order.value(), 4);
  }
}

TEST(Collect, FitsTheOrdersOfPowers) {
  const Result result = collect(sample_problem("sphere"), powers(0, 4), {});
  ASSERT_EQ(result.orders.size(), 2U);
  EXPECT_EQ(result.orders[0].quantity, "discretisation_error");
  EXPECT_EQ(result.orders[1].quantity, "node_error");
  EXPECT_NEAR(result.orders[0].order.value(), 2, 1e-14);
  EXPECT_NEAR(result.orders[1].order.value(), 4, 1e-14);
  for (const OrderFit& fit : result.orders) {
    EXPECT_LT(fit.halfwidth.value(), 1e-14);
    EXPECT_EQ(fit.levels, (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(fit.left_out.empty());
    EXPECT_EQ(fit.model, "h^p");
  }
}

TEST(Collect, TakesMeshSizesAndNotLevelsForOrders) {
  // Levels 0 and 2: h falls to a quarter, the ratio 16 is still order 2.
  const Result result = collect(sample_problem("sphere"), {powers(0, 0)[0], powers(2, 2)[0]}, {});
  EXPECT_EQ(result.levels[1].discretisation_ratio, 16);
  EXPECT_DOUBLE_EQ(result.levels[1].discretisation_order.value(), 2);
  EXPECT_NEAR(result.orders[0].order.value(), 2, 1e-14);
}

TEST(Collect, FitsByLeastSquaresAndSpansTheSuccessiveOrders) {
  // log2 of the errors: 0, -2, -4.75 at 0, 1, 2: successive orders 2 and 2.75, the regression line through
  // three equidistant points 2.375.
  const Result result = collect(sample_problem("sphere"),
                                {level(0, 1, 1), level(1, 0.25, 0.25), level(2, std::exp2(-4.75), 1)}, {});
  EXPECT_NEAR(result.orders[0].order.value(), 2.375, 1e-14);
  EXPECT_NEAR(result.orders[0].halfwidth.value(), 0.375, 1e-14);
  EXPECT_TRUE(result.orders[0].pre_asymptotic.empty());
}

TEST(Collect, LeavesOutPreAsymptoticLevels) {
  // log2 of the errors: 3, 0, -1, -4, -6, -8: slopes 3, 1, 3, 2, 2. From level 1 on 2.1 +- 1.1, from level 2
  // on 2.3 +- 0.7, from level 3 on 2.
  std::vector<LevelResult> levels;
  for (const double power : {3.0, 0.0, -1.0, -4.0, -6.0, -8.0})
    levels.push_back(level(static_cast<int>(levels.size()), std::exp2(power), std::exp2(power)));
  const Result result = collect(sample_problem("sphere"), levels, {});
  for (const OrderFit& fit : result.orders) {
    EXPECT_EQ(fit.levels, (std::vector<int>{3, 4, 5}));
    EXPECT_EQ(fit.pre_asymptotic, (std::vector<int>{0, 1, 2}));
    EXPECT_NEAR(fit.order.value(), 2, 1e-14);
    EXPECT_NEAR(fit.halfwidth.value(), 0, 1e-14);
  }
}

TEST(Collect, FitsNoOrderToSlopesThatAreNotSteady) {
  // Slopes 12.4 and -0.9: 5.75 +- 6.65 would be no order.
  const Result result =
      collect(sample_problem("sphere"),
              {level(0, 1, 1), level(1, std::exp2(-12.4), 1), level(2, std::exp2(-11.5), 1)}, {});
  EXPECT_EQ(result.orders[0].order, std::nullopt);
  EXPECT_EQ(result.orders[0].halfwidth, std::nullopt);
  EXPECT_TRUE(result.orders[0].levels.empty());
  EXPECT_EQ(result.orders[0].pre_asymptotic, (std::vector<int>{0, 1, 2}));
}

TEST(Collect, BeginsWithTheLevelThatTheProblemNames) {
  Problem problem = sample_problem("sphere");
  problem.fit_from = 1;
  // Slopes 0, 1 and 4: taken as they are from level 1 on.
  const Result result = collect(
      problem, {level(0, 1, 1), level(1, 1, 1), level(2, 0.5, 0.5), level(3, std::exp2(-5), std::exp2(-5))},
      {});
  EXPECT_EQ(result.orders[0].levels, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(result.orders[0].pre_asymptotic, std::vector<int>{0});
  EXPECT_NEAR(result.orders[0].order.value(), 2.5, 1e-14);
  EXPECT_NEAR(result.orders[0].halfwidth.value(), 1.5, 1e-14);
}

TEST(Collect, LeavesOutAndNamesALevelWhoseRadiusExceedsFivePercent) {
  std::vector<LevelResult> levels = powers(0, 3);
  levels[1].discretisation_error->radius = 0.05 * levels[1].discretisation_error->value;  // just admitted
  levels[2].discretisation_error->value *= 7;
  levels[2].discretisation_error->radius = 0.0501 * levels[2].discretisation_error->value;
  const Result result = collect(sample_problem("sphere"), levels, {});
  EXPECT_EQ(result.orders[0].levels, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(result.orders[0].left_out, std::vector<int>{2});
  EXPECT_NEAR(result.orders[0].order.value(), 2, 1e-14);  // the outlier had no say
  EXPECT_EQ(result.orders[1].left_out, std::vector<int>{});
  // Nor is there a ratio of it, from either side.
  EXPECT_NE(result.levels[1].discretisation_ratio, std::nullopt);
  for (const std::size_t k : {2U, 3U}) {
    EXPECT_EQ(result.levels[k].discretisation_ratio, std::nullopt);
    EXPECT_EQ(result.levels[k].discretisation_order, std::nullopt);
    EXPECT_NE(result.levels[k].node_ratio, std::nullopt);
  }
}

TEST(Collect, HasNoOrdersOfNoise) {
  // 1e-15 and 7e-16, of which all digits are rounding.
  const Result result =
      collect(sample_problem("sphere"), {level(0, 1e-15, 1e-15, 150), level(1, 7e-16, 7e-16, 400)}, {});
  EXPECT_EQ(result.levels[1].discretisation_ratio, std::nullopt);
  EXPECT_EQ(result.levels[1].node_order, std::nullopt);
  EXPECT_EQ(result.orders[0].order, std::nullopt);
}

TEST(Collect, LeavesOutErrorsThatAreZeroOrHaveNoRadius) {
  std::vector<LevelResult> levels = powers(0, 3);
  levels[0].node_error->radius = std::numeric_limits<double>::infinity();
  levels[3].node_error->value = 0;
  const Result result = collect(sample_problem("sphere"), levels, {});
  EXPECT_EQ(result.orders[1].levels, (std::vector<int>{1, 2}));
  EXPECT_EQ(result.orders[1].left_out, (std::vector<int>{0, 3}));
  EXPECT_NEAR(result.orders[1].order.value(), 4, 1e-14);
  EXPECT_EQ(result.levels[3].node_ratio, std::nullopt);
  EXPECT_EQ(result.levels[3].node_order, std::nullopt);
}

TEST(Collect, HasNoOrderOfOneLevel) {
  const Result result = collect(sample_problem("sphere"), powers(2, 2), {});
  ASSERT_EQ(result.orders.size(), 2U);
  EXPECT_EQ(result.orders[0].order, std::nullopt);
  EXPECT_EQ(result.orders[0].halfwidth, std::nullopt);
  EXPECT_EQ(result.orders[0].levels, std::vector<int>{2});
}

TEST(Collect, HasNoSpreadOfTwoLevels) {
  // One slope: that all slopes are within 0 of it says nothing.
  for (const std::optional<int> from : {std::optional<int>(), std::optional(1)}) {
    Problem problem = sample_problem("sphere");
    problem.fit_from = from;
    for (const OrderFit& fit : collect(problem, powers(from.value_or(0), from.value_or(0) + 1), {}).orders) {
      EXPECT_TRUE(fit.order.has_value());
      EXPECT_EQ(fit.halfwidth, std::nullopt);
    }
  }
}

TEST(Collect, FitsNothingForAGivenEmission) {
  LevelResult coarse;
  LevelResult fine;
  fine.level = 1;
  const Result result = collect(with_emission(sample_problem("sphere"), "1"), {coarse, fine}, {});
  EXPECT_TRUE(result.orders.empty());
  EXPECT_EQ(result.levels[1].discretisation_ratio, std::nullopt);
  EXPECT_EQ(result.levels[1].node_order, std::nullopt);
}

TEST(Collect, ForgetsTheRatiosThatTheLevelsBrought) {
  std::vector<LevelResult> levels = powers(0, 1);
  levels[0].node_ratio = levels[0].discretisation_ratio = 99;
  levels[0].node_order = levels[0].discretisation_order = 99;
  const Result result = collect(sample_problem("sphere"), levels, {});
  EXPECT_EQ(result.levels[0].node_ratio, std::nullopt);
  EXPECT_EQ(result.levels[0].discretisation_order, std::nullopt);
}

TEST(Collect, KeepsTheTimingAndRefusesLevelsOutOfOrder) {
  const std::vector<LevelTiming> timing{{.assembly_seconds = 1}, {.assembly_seconds = 2}};
  const Result result = collect(sample_problem("sphere"), powers(0, 1), timing);
  ASSERT_EQ(result.timing.size(), 2U);
  EXPECT_EQ(result.timing[1].assembly_seconds, 2);
  EXPECT_THROW(collect(sample_problem("sphere"), {powers(1, 1)[0], powers(0, 0)[0]}, {}), ContractViolation);
  EXPECT_THROW(collect(sample_problem("sphere"), {powers(1, 1)[0], powers(1, 1)[0]}, {}), ContractViolation);
}

}  // namespace
}  // namespace radcert
