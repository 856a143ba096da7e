// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/problem_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/formats/problem/problem_json.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Levels with as many elements as their number says, all alike.
class CountedLevels final : public LevelSource {
public:
  LevelOutcome level(const Problem& problem, int level) override {
    LevelOutcome outcome = made_up_level(problem, level);
    outcome.elements.assign(std::size_t{1} << (2 * static_cast<unsigned>(level)), ElementValue{});
    return outcome;
  }
};

TEST(RecordedLevels, KeepEachProblemOnceWithItsLevelsInOrder) {
  CountedLevels source;
  RecordedLevels levels(source);
  const Problem one = flat_problem({0, 1, 2});
  Problem other = one;
  triangle_basis_of(other.method).alpha = Rational(1, 5);
  for (const int level : {2, 0, 1, 0}) static_cast<void>(levels.level(one, level));
  static_cast<void>(levels.level(other, 1));
  EXPECT_THAT(levels.used(), ElementsAre(0U, 1U));
  const std::vector<ProblemTrace> traces = levels.problems();
  ASSERT_EQ(traces.size(), 2U);
  std::vector<int> seen;
  for (const LevelResult& each : traces[0].levels) seen.push_back(each.level);
  EXPECT_THAT(seen, ElementsAre(0, 1, 2));
  EXPECT_EQ(traces[0].levels[2].node_error->value, made_up_level(one, 2).result.node_error->value);
}

TEST(RecordedLevels, TakeTheLevelsOfOneProblemTogetherWhicheverAreAskedFor) {
  CountedLevels source;
  RecordedLevels levels(source);
  static_cast<void>(levels.level(flat_problem({0, 1}), 0));
  levels.begin();
  static_cast<void>(levels.level(flat_problem({1, 2}), 2));
  EXPECT_THAT(levels.used(), ElementsAre(0U));
  EXPECT_EQ(levels.problems().size(), 1U);
}

TEST(RecordedLevels, TakeTheLevelsOfSeveralSolversTogether) {
  class BySolver final : public LevelSource {
  public:
    LevelOutcome level(const Problem& problem, int level) override {
      LevelOutcome outcome = made_up_level(problem, level);
      if (problem.solver.name == "verified") outcome.result.verified.emplace();
      return outcome;
    }
  };
  BySolver source;
  RecordedLevels levels(source);
  Problem direct = flat_problem({0});
  direct.solver.name = "direct";
  Problem verified = direct;
  verified.solver.name = "verified";
  for (const int level : {0, 1, 2}) static_cast<void>(levels.level(direct, level));
  for (const int level : {0, 1}) static_cast<void>(levels.level(verified, level));
  const std::vector<ProblemTrace> traces = levels.problems();
  ASSERT_EQ(traces.size(), 1U);
  ASSERT_EQ(traces[0].levels.size(), 3U);
  EXPECT_TRUE(traces[0].levels[0].verified.has_value());
  EXPECT_TRUE(traces[0].levels[1].verified.has_value());
  EXPECT_FALSE(traces[0].levels[2].verified.has_value());
  EXPECT_EQ(traces[0].problem.solver.name, "direct");
  EXPECT_EQ(levels.asked().size(), 5U);
}

TEST(RecordedLevels, DrawTheFinestLevelThatIsClear) {
  CountedLevels source;
  RecordedLevels levels(source);
  const Problem problem = flat_problem({0});
  for (const int level : {5, 6, 4, 3}) static_cast<void>(levels.level(problem, level));
  EXPECT_EQ(levels.problems()[0].drawn_level, 4);  // 256 elements
  EXPECT_EQ(levels.problems()[0].elements.size(), RecordedLevels::most_drawn);
}

TEST(ProblemTitle, NamesWhatDiffersFromTheDefaults) {
  Problem problem = flat_problem({0});
  problem.triangulation.grading = Rational(3, 2);
  const std::string title = problem_title(problem);
  EXPECT_THAT(title, HasSubstr(problem.surface.name));
  EXPECT_THAT(title, HasSubstr("grading 3/2"));
  EXPECT_THAT(title, HasSubstr("degree " + std::to_string(triangle_basis_of(problem.method).degree)));
}

}  // namespace
}  // namespace radcert::verification
