// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "radcert/core/errors.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"
#include "tests/study/problems.h"
#include "tests/thread_ranks.h"

namespace radcert {
namespace {

using testing::fault_of;
using testing::no_route;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

Problem in_clusters(Problem problem) {
  problem.matrix.name = "h2";
  problem.matrix.tolerance = Rational(1, 1000000);
  problem.solver.name = "auto";
  return problem;
}

Problem on_ellipsoid() {
  return in_clusters(with_basis(sample_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}}), 1,
                                Rational(1, 6)));
}

LevelOutcome solved_by(std::size_t count, const Problem& problem, int level, bool fields = true) {
  LevelOutcome outcome;
  ThreadRanks::run(count, [&](const Ranks& ranks) {
    LevelOutcome own =
        solve_level(problem, level, reference::applied_operator, {.ranks = ranks, .fields = fields});
    if (ranks.is_first()) {
      outcome = std::move(own);
    } else {
      EXPECT_TRUE(own.nodes.empty());
    }
  });
  return outcome;
}

void expect_equal(const std::optional<Approximation>& a, const std::optional<Approximation>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->value, b->value);
  EXPECT_EQ(a->radius, b->radius);
}

void expect_same_numbers(const LevelResult& a, const LevelResult& b) {
  EXPECT_EQ(a.elements, b.elements);
  EXPECT_EQ(a.unknowns, b.unknowns);
  EXPECT_EQ(a.mesh_size, b.mesh_size);
  EXPECT_EQ(a.solution_radius, b.solution_radius);
  EXPECT_EQ(a.norm_K.value, b.norm_K.value);
  EXPECT_EQ(a.iteration->error_bound, b.iteration->error_bound);
  for (const auto figure : {&LevelResult::discretisation_error, &LevelResult::node_error,
                            &LevelResult::uniform_error, &LevelResult::l2_error, &LevelResult::mean_error})
    expect_equal(a.*figure, b.*figure);
  ASSERT_EQ(a.piece_means.size(), b.piece_means.size());
  for (std::size_t i = 0; i < a.piece_means.size(); ++i) {
    EXPECT_EQ(a.piece_means[i].first, b.piece_means[i].first);
    expect_equal(a.piece_means[i].second, b.piece_means[i].second);
  }
}

TEST(SharedLevel, HasTheBitsOfOneProcess) {
  std::vector<Problem> problems = {with_solution(on_ellipsoid(), "exp(x/2) + y*z"),
                                   with_emission(on_ellipsoid(), "1 + x")};
  problems.front().reflectivity = testing::everywhere("1/2 + x/8 + z/16");
  for (const Problem& problem : problems) {
    const LevelOutcome one = solve_level(problem, 2, reference::applied_operator);
    EXPECT_EQ(one.result.matrix_form, "h2");
    for (const std::size_t count : {2, 3, 7}) {
      const LevelOutcome many = solved_by(count, problem, 2);
      EXPECT_EQ(many.shared->ranks, count);
      EXPECT_GT(many.shared->bytes_sent, 0U);
      expect_same_numbers(many.result, one.result);
      ASSERT_EQ(many.nodes.size(), one.nodes.size());
      for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        EXPECT_EQ(many.nodes[i].u_n.value, one.nodes[i].u_n.value) << count << " node " << i;
        EXPECT_EQ(many.nodes[i].emission, one.nodes[i].emission) << count << " node " << i;
      }
      EXPECT_EQ(many.elements.size(), one.elements.size());
    }
  }
}

TEST(SharedLevel, HasItsNumbersWithoutAnybodyHavingAllOfIt) {
  // More than one piece, some on a rank alone.
  Problem problem = in_clusters(with_basis(sample_problem("cube"), 1, Rational(1, 6)));
  problem = with_solution(problem, "exp(x + y + z)");
  const LevelOutcome one = solve_level(problem, 3, reference::applied_operator);
  for (const std::size_t count : {2, 5}) {
    const LevelOutcome many = solved_by(count, problem, 3, false);
    expect_same_numbers(many.result, one.result);
    EXPECT_TRUE(many.is_without_fields());
    EXPECT_TRUE(many.elements.empty());
  }
}

// The rows are known worst in the west, which is the first rank's, and u on the ceiling, which is the last
// one's.
TEST(SharedLevel, TakesTheRadiusOfTheDataFromAllRanks) {
  Problem problem = in_clusters(with_basis(sample_problem("cube"), 1, Rational(1, 6)));
  problem.reflectivity = testing::by_piece({{"west", "3/4"}, {"*", "1/16"}});
  problem.solution = testing::by_piece({{"ceiling", "(1 + x + 1000000000) - 1000000000"}, {"*", "1"}});
  const OperatorRoute no_light = [](const Surface&, const SurfaceFunction&) {
    return [](const SurfacePoint<double>&) { return Approximation{0, 0}; };
  };
  const LevelOutcome one = solve_level(problem, 1, no_light);
  EXPECT_EQ(one.result.matrix_form, "h2");
  LevelOutcome two;
  ThreadRanks::run(2, [&](const Ranks& ranks) {
    LevelOutcome own = solve_level(problem, 1, no_light, {.ranks = ranks});
    if (ranks.is_first()) two = std::move(own);
  });
  EXPECT_GT(one.result.discretisation_error->radius, 1e-7);
  EXPECT_LT(one.result.discretisation_error->radius, 1e-4);
  expect_equal(two.result.discretisation_error, one.result.discretisation_error);
}

/// Keeps numbers, and stops the work after so many times.
class StoppingMemory final : public KeptNumbers {
public:
  std::optional<std::vector<double>> find(const std::string& name) override {
    const auto at = numbers.find(name);
    return at == numbers.end() ? std::nullopt : std::optional(at->second);
  }
  void keep(const std::string& name, std::span<const double> kept) override {
    numbers[name].assign(kept.begin(), kept.end());
    if (--left == 0) throw Interrupted();
  }
  std::map<std::string, std::vector<double>> numbers;
  int left = 0;
};

TEST(SharedLevel, GoesOnFromWhatOtherRanksHaveKept) {
  Problem problem = with_solution(on_ellipsoid(), "exp(x/2) + y*z");
  // So slow that there are many corrections.
  problem.solver.name = "neumann";
  const LevelOutcome whole = solve_level(problem, 2, reference::applied_operator);
  for (const int stop : {2, 3, 7}) {
    StoppingMemory memory;
    memory.left = stop;
    EXPECT_THROW(ThreadRanks::run(3,
                                  [&](const Ranks& ranks) {
                                    static_cast<void>(solve_level(problem, 2, reference::applied_operator,
                                                                  {.ranks = ranks}, &memory));
                                  }),
                 Interrupted)
        << stop;
    LevelOutcome outcome;
    // Ku is not computed again.
    ThreadRanks::run(2, [&](const Ranks& ranks) {
      LevelOutcome own = solve_level(problem, 2, no_route, {.ranks = ranks}, &memory);
      if (ranks.is_first()) outcome = std::move(own);
    });
    EXPECT_EQ(outcome.result.iteration->iterations, whole.result.iteration->iterations) << stop;
    EXPECT_EQ(outcome.result.iteration->error_bound, whole.result.iteration->error_bound) << stop;
    ASSERT_EQ(outcome.nodes.size(), whole.nodes.size());
    for (std::size_t i = 0; i < whole.nodes.size(); ++i)
      ASSERT_EQ(outcome.nodes[i].u_n.value, whole.nodes[i].u_n.value) << stop << " node " << i;
    if (stop > 2) {
      EXPECT_GT(memory.numbers.at("iteration").size(), 2 * whole.nodes.size());
    }
  }
}

TEST(SharedLevel, NamesTheNodeAsOneProcessDoes) {
  Problem problem = with_emission(on_ellipsoid(), "1");
  // Above 1 near one end of the last axis.
  problem.reflectivity = testing::everywhere("1/2 + sqrt((z + 1)^2) - (z + 1)");
  const InputFault one = fault_of([&] { solve_level(problem, 2, no_route); });
  const InputFault many = fault_of([&] { solved_by(3, problem, 2); });
  EXPECT_EQ(many.pointer, one.pointer);
  EXPECT_EQ(many.problem, one.problem);
  EXPECT_EQ(many.value, one.value);
}

TEST(SharedLevel, RefusesMoreRanksThanSubtrees) {
  const Problem problem = with_emission(on_ellipsoid(), "1");
  EXPECT_EQ(fault_of([&] { solved_by(33, problem, 2); }).source, "the number of ranks");
}

TEST(SharedLevel, IsTheFirstRanksWhereTheMatrixIsDense) {
  Problem problem = with_emission(on_ellipsoid(), "1 + x");
  problem.matrix.name = "dense";
  const LevelOutcome one = solve_level(problem, 1, no_route);
  const LevelOutcome many = solved_by(3, problem, 1);
  ASSERT_EQ(many.nodes.size(), one.nodes.size());
  for (std::size_t i = 0; i < one.nodes.size(); ++i)
    EXPECT_EQ(many.nodes[i].u_n.value, one.nodes[i].u_n.value);
}

}  // namespace
}  // namespace radcert
