// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/stored_finding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "radcert/core/files/result_store.h"
#include "radcert/formats/result/stored_levels.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Every kind of evidence, numbers that are not finite, and a level.
Finding all_kinds(const Bench& bench) {
  static_cast<void>(bench.levels.level(flat_problem({0}), 2));
  Finding finding;
  finding.require("a third \"of\" 1", IsExactly{Rational(1, 3)}, Rational(1, 3));
  finding.control("a quarter", IsExactly{Rational(1, 3)}, Rational(1, 4));
  finding.require("a ball", LiesIn{.least = 0, .largest = 1}, sqrt(Ball(Rational(1, 2))));
  finding.control("another", LiesIn{.least = 0, .largest = 1}, Ball(2));
  finding.require("unbounded", AtMost{.value = 1, .slack = 0.5, .why = "a reason"},
                  Approximation{.value = infinity, .radius = infinity});
  finding.control("large", AtMost{.value = 1, .slack = 0, .why = ""},
                  Approximation::proved(0x1p+900, 0x1p-1000));
  finding.instead("no number", AgreesWith{.value = Ball(1), .within = 0.5}, log(Ball(0)));
  finding.remark("beside", {.value = 0.1, .radius = 1e-17});
  finding.show({.value = 0.1, .radius = infinity});
  return finding;
}

void expect_same(const Finding& a, const Finding& b) {
  EXPECT_EQ(a.verdict(), b.verdict());
  EXPECT_EQ(a.remarks(), b.remarks());
  ASSERT_EQ(a.figure().has_value(), b.figure().has_value());
  EXPECT_EQ(a.figure()->value, b.figure()->value);
  EXPECT_EQ(a.figure()->radius, b.figure()->radius);
  EXPECT_EQ(a.figure()->guaranteed, b.figure()->guaranteed);
  ASSERT_EQ(a.evidence().size(), b.evidence().size());
  for (std::size_t i = 0; i < a.evidence().size(); ++i) {
    const Evidence& one = a.evidence()[i];
    const Evidence& other = b.evidence()[i];
    EXPECT_EQ(one.what, other.what);
    EXPECT_EQ(one.value, other.value);
    EXPECT_EQ(one.radius, other.radius);
    EXPECT_EQ(one.allowed, other.allowed);
    EXPECT_EQ(one.standing, other.standing);
    EXPECT_TRUE(one.number == other.number || (std::isnan(one.number) && std::isnan(other.number)));
    EXPECT_EQ(one.kind, other.kind);
    EXPECT_EQ(one.role, other.role);
    EXPECT_EQ(one.proved, other.proved);
  }
}

// What a run of its own finds under a name, how often the check ran, and which levels it stands on.
struct Looked {
  Finding finding;
  int checked = 0;
  std::size_t problems = 0;
};

Looked run_in(ResultStore& store, Budget budget, const Check& check, const std::string& name = "own/a") {
  StoredLevels source(store, made_up_level);
  RecordedLevels levels(source);
  const Bench bench{.budget = budget, .route = {}, .levels = levels, .store = store};
  Looked run;
  run.finding = stored_finding(
                    [&](const Bench& given) {
                      ++run.checked;
                      return check(given);
                    },
                    name, bench, levels)
                    .finding;
  run.problems = levels.used().size();
  return run;
}

// The same without the evidence that makes it fail.
Finding settled(const Bench& bench) {
  const Finding all = all_kinds(bench);
  std::vector<Evidence> kept;
  for (const Evidence& each : all.evidence())
    if (each.role != Role::instead) kept.push_back(each);
  return Finding::restored(kept, all.remarks(), all.figure());
}

TEST(StoredFinding, ComesBackToTheBitWithItsProblems) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  const Looked first = run_in(store, Budget::quick, settled);
  EXPECT_EQ(first.finding.verdict(), Verdict::undecided);
  const Looked second = run_in(store, Budget::quick, settled);
  EXPECT_EQ(first.checked, 1);
  EXPECT_EQ(second.checked, 0);
  EXPECT_EQ(first.problems, 1U);
  EXPECT_EQ(second.problems, 1U);
  expect_same(first.finding, second.finding);
}

TEST(StoredFinding, IsThatOfItsStatementAndBudget) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  EXPECT_EQ(run_in(store, Budget::quick, settled).checked, 1);
  EXPECT_EQ(run_in(store, Budget::full, settled).checked, 1);
  EXPECT_EQ(run_in(store, Budget::quick, settled, "own/b").checked, 1);
  ResultStore fresh(folder.path());
  fresh.ignore_earlier();
  EXPECT_EQ(run_in(fresh, Budget::quick, settled).checked, 1);
}

TEST(StoredFinding, IsNotKeptWhereItFailed) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  EXPECT_EQ(run_in(store, Budget::quick, all_kinds).finding.verdict(), Verdict::failed);
  EXPECT_EQ(run_in(store, Budget::quick, all_kinds).checked, 1);
}

}  // namespace
}  // namespace radcert::verification
