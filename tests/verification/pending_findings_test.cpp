// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/pending_findings.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/parallel.h"
#include "radcert/formats/result/stored_levels.h"
#include "tests/verification/fixtures.h"
#include "verification/framework/stored_finding.h"

namespace radcert::verification {
namespace {

Finding one_half() {
  Finding finding;
  finding.require("1/2", IsExactly{Rational(1, 2)}, Rational(1, 2));
  finding.control("1/3", IsExactly{Rational(1, 2)}, Rational(1, 3));
  return finding;
}

std::vector<PendingFinding> pending(const std::vector<Check>& checks) {
  std::vector<PendingFinding> out;
  for (const Check& check : checks) out.push_back({"own/" + std::to_string(out.size()), &check});
  return out;
}

// Levels that notice two computations at a time.
class OneAtATime final : public LevelSource {
public:
  LevelOutcome level(const Problem& problem, int level) override {
    if (++inside_ > 1) together_ = true;
    LevelOutcome outcome = made_up_level(problem, level);
    --inside_;
    return outcome;
  }
  [[nodiscard]] bool together() const { return together_; }

private:
  std::atomic<int> inside_ = 0;
  std::atomic<bool> together_ = false;
};

TEST(PendingFindings, AreAllKeptAndToldOnce) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  OneAtATime levels;
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  const std::vector<Check> checks(40, [](const Bench& given) {
    for (const int level : {0, 1}) static_cast<void>(given.levels.level(flat_problem({0}), level));
    return one_half();
  });
  std::multiset<std::string> told;
  find_pending(pending(checks), bench, [&](const PendingFinding& one) { told.insert(one.statement); });
  EXPECT_EQ(told.size(), checks.size());
  EXPECT_EQ(std::set<std::string>(told.begin(), told.end()).size(), checks.size());
  for (const PendingFinding& one : pending(checks)) EXPECT_TRUE(is_stored(one.statement, bench));
  EXPECT_FALSE(levels.together());
}

TEST(PendingFindings, LeaveWhatThrowsPending) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  OneAtATime levels;
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  const std::vector<Check> checks{[](const Bench&) -> Finding { throw std::runtime_error("out of luck"); },
                                  [](const Bench&) { return one_half(); }};
  find_pending(pending(checks), bench, [](const PendingFinding&) {});
  EXPECT_FALSE(is_stored("own/0", bench));
  EXPECT_TRUE(is_stored("own/1", bench));
}

TEST(PendingFindings, PassOnAnInterruption) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  OneAtATime levels;
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  const std::vector<Check> checks(3, [](const Bench&) -> Finding { throw Interrupted(); });
  EXPECT_THROW(find_pending(pending(checks), bench, [](const PendingFinding&) {}), Interrupted);
}

TEST(PendingFindings, AreLeftWhereNothingIsKept) {
  const test::TemporaryFolder folder;
  const std::filesystem::path in_the_way = folder.path() / "file";
  std::ofstream(in_the_way) << "no folder";
  ResultStore store(in_the_way);
  OneAtATime levels;
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  std::atomic<std::size_t> run = 0;
  const std::vector<Check> checks(1000, [&](const Bench&) {
    ++run;
    return one_half();
  });
  find_pending(pending(checks), bench, [](const PendingFinding&) {});
  EXPECT_FALSE(store.status());
  EXPECT_LE(run, thread_count());
}

}  // namespace
}  // namespace radcert::verification
