// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/level_record.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>

#include "radcert/core/files/result_store.h"
#include "radcert/formats/result/stored_levels.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

void expect_same(const Approximation& a, const Approximation& b) {
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.guaranteed, b.guaranteed);
}

TEST(LevelRecord, ReadsBackToTheBit) {
  const LevelOutcome level = test::sample_level();
  const Outcome<LevelOutcome> back = read_level_record(level_record(level));
  ASSERT_TRUE(back) << back.reason();
  EXPECT_EQ(level_record(*back), level_record(level));
  EXPECT_EQ(back->result.planned_bytes, level.result.planned_bytes);
  EXPECT_EQ(back->result.discretisation_error->radius, level.result.discretisation_error->radius);
  EXPECT_FALSE(back->result.node_error->has_radius());
  EXPECT_FALSE(back->result.uniform_error);
  ASSERT_EQ(back->result.piece_means.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back->result.piece_means[i].first, level.result.piece_means[i].first);
    expect_same(back->result.piece_means[i].second, level.result.piece_means[i].second);
  }
  EXPECT_EQ(back->result.solution_radius, level.result.solution_radius);
  EXPECT_TRUE(std::signbit(back->nodes[0].point.y));
  EXPECT_EQ(back->nodes[1].piece, level.nodes[1].piece);
  for (std::size_t i = 0; i < 2; ++i) expect_same(back->nodes[i].u_n, level.nodes[i].u_n);
  EXPECT_FALSE(back->nodes[1].u);
  EXPECT_EQ(back->elements[1].corner_values, level.elements[1].corner_values);
  EXPECT_EQ(back->timing.solve_seconds, level.timing.solve_seconds);
}

TEST(LevelRecord, ReadsTheIteratedSolutionBack) {
  LevelOutcome level = test::sample_level();
  level.result.iterated_error = Approximation::estimated(0.1, 1e-17);
  level.result.iterated = {.check_points = 24,
                           .u_n_error = Approximation::without_radius(0.3),
                           .node_error = Approximation::estimated(0.7, 1e-9),
                           .difference = Approximation::estimated(1.0 / 3, 1e-18),
                           .l2_error = 0.2,
                           .mean_error = 1e-3,
                           .piece_means = {{"lower", 0.4}, {"upper", 0.6}}};
  level.result.l2_error = Approximation::without_radius(0.9);
  level.timing.iterated_seconds = 0.25;
  level.elements[1].iterated = {0.1, -0.0, 3};
  const Outcome<LevelOutcome> back = read_level_record(level_record(level));
  ASSERT_TRUE(back) << back.reason();
  EXPECT_EQ(level_record(*back), level_record(level));
  EXPECT_EQ(back->result.iterated->check_points, 24U);
  expect_same(*back->result.iterated_error, *level.result.iterated_error);
  expect_same(back->result.iterated->difference, level.result.iterated->difference);
  EXPECT_EQ(back->result.iterated->piece_means, level.result.iterated->piece_means);
  expect_same(*back->result.l2_error, *level.result.l2_error);
  EXPECT_EQ(back->timing.iterated_seconds, 0.25);
  EXPECT_FALSE(back->elements[0].iterated);
  EXPECT_EQ(back->elements[1].iterated, level.elements[1].iterated);
}

TEST(LevelRecord, IsRefusedWhereItIsDamaged) {
  const std::string text = level_record(test::sample_level());
  EXPECT_FALSE(read_level_record(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(read_level_record("{}"));
  EXPECT_FALSE(read_level_record("[]"));
  EXPECT_FALSE(read_level_record(""));
  std::string fewer_cells = text;
  fewer_cells.replace(fewer_cells.find("[\"upper\", 1, 2, "), 16, "[\"upper\", 1, ");
  EXPECT_FALSE(read_level_record(fewer_cells));
}

TEST(LevelKey, DependsOnTheProblemAndTheLevelButNotOnTheOtherLevels) {
  Problem problem = test::sample_problem();
  const std::string key = level_key(problem, 1);
  EXPECT_NE(level_key(problem, 2), key);
  problem.triangulation.levels = {1, 5};
  EXPECT_EQ(level_key(problem, 1), key);
  triangle_basis_of(problem.method).alpha = Rational(1, 7);
  EXPECT_NE(level_key(problem, 1), key);
}

TEST(LevelKey, DependsOnTheContentOfAFileOfNodes) {
  Problem problem = test::sample_problem();
  problem.method = Collocation{{.family = NodeFamily::file, .file = "nodes.json", .digest = "one"}};
  const std::string key = level_key(problem, 1);
  triangle_basis_of(problem.method).digest = "another";
  EXPECT_NE(level_key(problem, 1), key);
}

/// A folder that goes with the test.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("radcert-levels-" + std::to_string(getpid()));
  Folder() { std::filesystem::remove_all(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

TEST(StoredLevels, ComputeAgainWhereNodesAndElementsAreWantedAndWereNotKept) {
  const Folder folder;
  ResultStore store(folder.path);
  const auto solve = [](bool fields) {
    return [fields](const Problem&, int) {
      LevelOutcome level = test::sample_level();
      if (fields) return level;
      return LevelOutcome{.result = level.result, .timing = level.timing, .nodes = {}, .elements = {}};
    };
  };
  const auto computed = [&](bool fields) {
    StoredLevels levels(store, solve(fields), {.fields = fields});
    const LevelOutcome found = levels.level(test::sample_problem(), 0);
    EXPECT_TRUE(!fields || !found.is_without_fields());
    return levels.computed();
  };
  EXPECT_EQ(computed(false), 1U);
  EXPECT_EQ(computed(false), 0U);
  EXPECT_EQ(computed(true), 1U);
  EXPECT_EQ(computed(false), 0U);
  EXPECT_EQ(computed(true), 0U);
}

TEST(StoredLevels, KeepNothingOfAFunctionWithoutAFormula) {
  const Folder folder;
  ResultStore store(folder.path);
  StoredLevels levels(store, [](const Problem&, int) { return test::sample_level(); });
  Problem problem = test::sample_problem();
  const auto one = [](auto, auto, auto, std::span<double> values) { std::ranges::fill(values, 1); };
  for (auto* data : {&problem.solution, &problem.emission}) {
    const std::size_t before = levels.computed();
    problem = test::sample_problem();
    problem.solution.reset();
    problem.emission.reset();
    *data = own_function({.words = "a function", .values = one});
    static_cast<void>(levels.level(problem, 0));
    static_cast<void>(levels.level(problem, 0));
    EXPECT_EQ(levels.computed(), before + 2);
    EXPECT_FALSE(std::filesystem::exists(folder.path));
  }
  // Its name is that of another mother function too.
  problem = test::sample_problem();
  Meshless meshless{.family = MeshlessFamily::meshless, .basis = shepard_basis()};
  meshless.basis.mother = own_mother("mine", [](double r) { return std::exp(-r); });
  problem.method = meshless;
  static_cast<void>(levels.level(problem, 0));
  static_cast<void>(levels.level(problem, 0));
  EXPECT_EQ(levels.computed(), 6U);
  EXPECT_FALSE(std::filesystem::exists(folder.path));
  // What its text tells is kept.
  problem = test::sample_problem();
  static_cast<void>(levels.level(problem, 0));
  static_cast<void>(levels.level(problem, 0));
  EXPECT_EQ(levels.computed(), 7U);
}

}  // namespace
}  // namespace radcert
