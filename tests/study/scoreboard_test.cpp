// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/scoreboard.h"

#include <gtest/gtest.h>

#include <random>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(ParetoFrontier, HasWhatNothingIsBetterThan) {
  const std::vector<CostPoint> points = {{1, 8}, {2, 4}, {2, 5}, {3, 4}, {4, 1}, {4, 1}, {9, 2}};
  EXPECT_EQ(pareto_frontier(points), (std::vector<bool>{true, true, false, false, true, true, false}));
  EXPECT_TRUE(pareto_frontier({}).empty());
}

TEST(ParetoFrontier, DominatesTheRestAndNotItself) {
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> small(1, 9);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<CostPoint> points;
    for (int i = 0; i < 12; ++i)
      points.push_back({static_cast<double>(small(generator)), static_cast<double>(small(generator))});
    const std::vector<bool> on = pareto_frontier(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool dominated = false;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const bool no_worse = points[j].cost <= points[i].cost && points[j].error <= points[i].error;
        const bool differs = points[j].cost != points[i].cost || points[j].error != points[i].error;
        if (on[j] && no_worse && differs) dominated = true;
      }
      EXPECT_EQ(on[i], !dominated);
    }
  }
}

LevelResult level_with_means(double floor, double wall) {
  LevelResult level;
  level.unknowns = 10;
  level.piece_means = {{"floor", Approximation::without_radius(floor)},
                       {"wall", Approximation::without_radius(wall)}};
  level.l2_error = Approximation::without_radius(0.25);
  level.mean_error = Approximation::without_radius(0.125);
  level.uniform_error = Approximation::without_radius(0.5);
  return level;
}

TEST(BoardPoint, TakesTheMeansThatAreKnown) {
  const LevelTiming timing{
      .assembly_seconds = 1, .operator_seconds = 8, .solve_seconds = 2, .iterated_seconds = 4};
  const KnownMeans known = {{"floor", Approximation::estimated(1, 0)},
                            {"wall", Approximation::estimated(2, 0)}};
  LevelResult level = level_with_means(1.5, 1.25);
  EXPECT_EQ(board_point(level, timing, known).errors[2], 0.75);
  EXPECT_EQ(board_point(level, timing, {}).errors[2], 0.125);
  EXPECT_EQ(board_point(level, timing, {}).errors[0], 0.5);
  EXPECT_EQ(board_point(level, timing, {}).errors[1], 0.25);
  EXPECT_EQ(board_point(level, timing, {}).seconds, 3);
  EXPECT_THROW(static_cast<void>(iterated_board_point(level, timing, known)), ContractViolation);
  level.iterated.emplace();
  level.iterated->piece_means = {{"wall", 2.5}, {"floor", 1.0}};
  EXPECT_EQ(iterated_board_point(level, timing, known).errors[2], 0.5);
  EXPECT_EQ(iterated_board_point(level, timing, known).seconds, 7);
  EXPECT_FALSE(iterated_board_point(level, timing, known).errors[0]);
}

TEST(Scoreboard, MarksEachErrorAgainstEachCost) {
  BoardProblem problem{.name = "p", .words = {}, .truth = {}, .truth_radius = {}};
  problem.cells = {
      {.method = "a",
       .points = {{.level = 0, .unknowns = 10, .bytes = 100, .seconds = 5, .errors = {1.0, 1.0, {}}}}},
      {.method = "none", .refusal = "why"},
      {.method = "b",
       .points = {{.level = 0, .unknowns = 20, .bytes = 100, .seconds = 1, .errors = {2.0, 0.5, 3.0}}}}};
  mark_frontiers(problem);
  const auto& a = problem.cells[0].points[0].on_frontier;
  const auto& b = problem.cells[2].points[0].on_frontier;
  EXPECT_EQ(a[0], (std::array<bool, 3>{true, true, true}));
  EXPECT_EQ(b[0], (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(a[1], (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(b[1], (std::array<bool, 3>{true, true, true}));
  EXPECT_EQ(a[2], (std::array<bool, 3>{false, false, false}));
  EXPECT_EQ(b[2], (std::array<bool, 3>{true, true, true}));
}

}  // namespace
}  // namespace radcert
