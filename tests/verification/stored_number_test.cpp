// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/stored_number.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/formats/result/stored_levels.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

TEST(StoredLevels, AreComputedOnceAcrossRuns) {
  const test::TemporaryFolder folder;
  const Problem problem = flat_problem({0, 1, 2});
  {
    ResultStore store(folder.path());
    StoredLevels levels(store, made_up_level);
    static_cast<void>(levels.level(problem, 0));
    static_cast<void>(levels.level(problem, 1));
    static_cast<void>(levels.level(problem, 0));
    EXPECT_EQ(levels.computed(), 2U);
  }
  ResultStore store(folder.path());
  StoredLevels levels(store, made_up_level);
  for (const int level : {0, 1, 2}) {
    const LevelOutcome outcome = levels.level(problem, level);
    EXPECT_EQ(outcome.result.node_error->value, made_up_level(problem, level).result.node_error->value);
    EXPECT_EQ(outcome.result.elements, made_up_level(problem, level).result.elements);
  }
  EXPECT_EQ(levels.computed(), 1U);
}

TEST(StoredLevels, KeepWhatWasDoneBeforeAnInterruption) {
  const test::TemporaryFolder folder;
  const Problem problem = flat_problem({0, 1, 2});
  {
    ResultStore store(folder.path());
    StoredLevels levels(store, [](const Problem& p, int level) {
      if (level == 2) throw Interrupted();
      return made_up_level(p, level);
    });
    static_cast<void>(levels.level(problem, 0));
    static_cast<void>(levels.level(problem, 1));
    EXPECT_THROW(static_cast<void>(levels.level(problem, 2)), Interrupted);
  }
  ResultStore store(folder.path());
  StoredLevels levels(store, made_up_level);
  for (const int level : {0, 1, 2}) static_cast<void>(levels.level(problem, level));
  EXPECT_EQ(levels.computed(), 1U);
}

TEST(StoredLevels, TellProblemsApart) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  StoredLevels levels(store, made_up_level);
  static_cast<void>(levels.level(flat_problem({0}), 0));
  Problem other = flat_problem({0});
  triangle_basis_of(other.method).alpha = Rational(1, 10);
  static_cast<void>(levels.level(other, 0));
  EXPECT_EQ(levels.computed(), 2U);
  // Which other levels a problem asks for does not matter.
  static_cast<void>(levels.level(flat_problem({0, 1}), 0));
  EXPECT_EQ(levels.computed(), 2U);
}

TEST(StoredNumber, ComesBackToTheBit) {
  const test::TemporaryFolder folder;
  ResultStore store(folder.path());
  const Approximation number{.value = 0.1, .radius = 3e-17, .guaranteed = true};
  int computed = 0;
  const auto compute = [&] {
    ++computed;
    return number;
  };
  for (int i = 0; i < 2; ++i) {
    const Approximation back = stored(store, "key", compute);
    EXPECT_EQ(back.value, number.value);
    EXPECT_EQ(back.radius, number.radius);
    EXPECT_TRUE(back.guaranteed);
  }
  EXPECT_EQ(computed, 1);
}

}  // namespace
}  // namespace radcert::verification
