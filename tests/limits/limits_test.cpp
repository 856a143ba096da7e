// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/limits/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

using limits::Answer;
using limits::Case;

const WorkLimit* find(const std::string& name) {
  for (const WorkLimit* limit : work_limits())
    if (limit->name() == name) return limit;
  return nullptr;
}

/// An exception that leaves the computation is a refusal.
Answer answer_of(const Case& one) {
  const BallPrecision precision(128);
  try {
    return one.answer();
  } catch (const std::exception& refused) {
    return limits::refusal(refused.what());
  }
}

std::string text_of(const Answer& answer) {
  std::string text = answer.verdict.empty() ? "" : answer.verdict + " ";
  for (const Ball& ball : answer.numbers) text += ball.to_text(20) + ", ";
  return text + "(" + answer.note + ")";
}

bool is_same(const Ball& a, const Ball& b) {
  if (!a.is_finite() || !b.is_finite()) return a.is_finite() == b.is_finite();
  return a.to_text(40) == b.to_text(40);
}

bool is_same(const Answer& a, const Answer& b) {
  return a.verdict == b.verdict && a.note == b.note &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(),
                    [](const Ball& x, const Ball& y) { return is_same(x, y); });
}

/// Nothing that is told differs from the truth by more than its radius.
void expect_true(const Answer& answer, const Answer& usual, const std::vector<Ball>& truth,
                 const std::string& what) {
  EXPECT_TRUE(answer.verdict.empty() || answer.verdict == usual.verdict) << what;
  if (answer.numbers.empty()) return;
  const std::vector<Ball>& expected = truth.empty() ? usual.numbers : truth;
  ASSERT_EQ(answer.numbers.size(), expected.size()) << what;
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_TRUE(!answer.numbers[k].is_finite() || overlaps(answer.numbers[k], expected[k]))
        << what << "\n number " << k << ": " << answer.numbers[k].to_text(20) << ", in truth "
        << expected[k].to_text(20);
}

void expect_nothing_false(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const std::string name = one.limit + (one.about.empty() ? "" : ", " + one.about);
    const WorkLimit* limit = find(one.limit);
    ASSERT_NE(limit, nullptr) << name;
    const Answer usual = answer_of(one);
    const BallPrecision precision(128);
    const std::vector<Ball> truth = one.truth();
    EXPECT_FALSE(usual.tells_nothing()) << name << ": " << text_of(usual);
    expect_true(usual, usual, truth, name + ", as usual");
    std::set<long> values{limit->smallest()};
    if (!one.is_long)
      values.insert(
          {std::min(limit->smallest() + 1, limit->usual()), (limit->smallest() + limit->usual()) / 2});
    bool is_reached = false;
    for (const long value : values) {
      const LoweredWorkLimit lowered(*limit, value);
      const Answer answer = answer_of(one);
      is_reached = is_reached || !is_same(answer, usual);
      expect_true(
          answer, usual, truth,
          name + " at " + std::to_string(value) + "\n " + text_of(answer) + "\n as usual " + text_of(usual));
    }
    EXPECT_TRUE(is_reached) << name << ": the same answer with a lower limit: " << text_of(usual);
  }
}

TEST(Limits, LeaveFormulasTrue) { expect_nothing_false(limits::formula_cases()); }
TEST(Limits, LeaveSolutionsTrue) { expect_nothing_false(limits::continuous_cases()); }
TEST(Limits, LeaveCertificatesTrue) { expect_nothing_false(limits::certificate_cases()); }
TEST(Limits, LeaveEnclosuresTrue) { expect_nothing_false(limits::enclosure_cases()); }
TEST(Limits, LeaveGalerkinTrue) { expect_nothing_false(limits::galerkin_cases()); }
TEST(Limits, LeaveMeshlessTrue) { expect_nothing_false(limits::meshless_cases()); }
TEST(Limits, LeavePolygonsTrue) { expect_nothing_false(limits::polygon_cases()); }
TEST(Limits, LeaveReferenceValuesTrue) { expect_nothing_false(limits::reference_cases()); }
TEST(Limits, LeaveSystemsTrue) { expect_nothing_false(limits::system_cases()); }

TEST(Limits, HaveACaseEach) {
  std::set<std::string> covered;
  for (const auto& cases : {limits::formula_cases(), limits::enclosure_cases(), limits::galerkin_cases(),
                            limits::meshless_cases(), limits::reference_cases(), limits::polygon_cases(),
                            limits::system_cases(), limits::continuous_cases(), limits::certificate_cases()})
    for (const Case& one : cases) covered.insert(one.limit);
  std::set<std::string> names;
  for (const WorkLimit* limit : work_limits()) {
    EXPECT_TRUE(covered.contains(std::string(limit->name()))) << limit->name() << " is lowered by no case";
    EXPECT_TRUE(names.insert(std::string(limit->name())).second) << limit->name() << " is the name of two";
    EXPECT_LT(limit->smallest(), limit->usual()) << limit->name();
    EXPECT_EQ(limit->value(), limit->usual()) << limit->name();
    EXPECT_FALSE(limit->at_the_limit().empty()) << limit->name();
  }
}

/// The rows of lib/limits.md: name, usual value, smallest, what happens.
std::string row_of(const WorkLimit& limit) {
  std::ostringstream row;
  row << "| `" << limit.name() << "` | " << limit.usual() << " | " << limit.smallest() << " | "
      << limit.at_the_limit() << " |";
  return row.str();
}

TEST(Limits, AreTheOnesOfTheDocumentation) {
  std::ifstream file(std::string(RADCERT_SOURCE_DIR) + "/lib/limits.md");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::string missing;
  for (const WorkLimit* limit : work_limits())
    if (text.find(row_of(*limit) + "\n") == std::string::npos) missing += row_of(*limit) + "\n";
  EXPECT_TRUE(missing.empty()) << "lib/limits.md has no such rows:\n" << missing;
  std::size_t rows = 0;
  for (std::size_t at = text.find("\n| `"); at != std::string::npos; at = text.find("\n| `", at + 1)) ++rows;
  EXPECT_EQ(rows, work_limits().size()) << "rows of limits that are no more";
}

TEST(WorkLimit, IsLoweredForTheTimeOfAScope) {
  const WorkLimit& limit = *work_limits().front();
  {
    const LoweredWorkLimit lowered(limit, limit.smallest());
    EXPECT_EQ(limit.value(), limit.smallest());
  }
  EXPECT_EQ(limit.value(), limit.usual());
  EXPECT_THROW(LoweredWorkLimit(limit, limit.smallest() - 1), ContractViolation);
  EXPECT_THROW(LoweredWorkLimit(limit, limit.usual() + 1), ContractViolation);
  EXPECT_EQ(limit.value(), limit.usual());
}

}  // namespace
}  // namespace radcert
