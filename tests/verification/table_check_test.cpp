// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/table_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "tests/core/refusal.h"
#include "tests/verification/fixtures.h"
#include "verification/framework/run_verification.h"

namespace radcert::verification {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string problem_file(const std::string& alpha, const std::string& levels) {
  return R"({"schema": "radcert/problem/1", "surface": {"name": "cube"}, "triangulation": {"levels": [)" +
         levels + R"(]}, "basis": {"family": "inset", "degree": 1, "alpha": ")" + alpha +
         R"("}, "reflectivity": "0.5", "solution": "x"})";
}

// Two rows that fit the made-up levels; the last cell is empty.
constexpr const char* table = "# a comment\nn,error,ratio\n12,1.0E0,\n48,2.5E-1,4.0\n";
constexpr const char* head = R"([table_9]
says = "a table"
check = "table"
table = "table_9.csv"

[[table_9.series]]
problem = "problem.json"
control = "control.json"
figures = {node_error = "error", node_ratio = "ratio"}

)";
constexpr const char* cells = R"([table_9.n12]
node_error = {verdict = "reproduced"}

[table_9.n48]
node_error = {verdict = "reproduced"}
node_ratio.verdict = "reproduced"
)";

Paper paper_of(const std::string& claims, std::map<std::string, std::string> changed = {}) {
  std::map<std::string, std::string> files{{"table_9.csv", table},
                                           {"problem.json", problem_file("1/6", "0, 1")},
                                           {"control.json", problem_file("1/10", "0")}};
  for (auto& [name, text] : changed) files[name] = text;
  Paper paper;
  paper.key = "own";
  paper.source = [](const std::string& path) { return "own/" + path; };
  paper.file = [files](const std::string& path) {
    if (!files.contains(path)) throw InputError({.source = "own/" + path, .problem = "is missing"});
    return files.at(path);
  };
  paper.claims = read_claims(claims, "own/claims.toml");
  return paper;
}

class OnABench : public testing::Test {
protected:
  std::vector<ClaimReport> check(const Paper& paper, const SecondRoute& route = {}) {
    return check_table(paper, paper.claims.at(0), bench_, route, [](const std::string&) { return true; });
  }
  std::string refusal(const Paper& paper) {
    return test::refusal_of([&] { return check(paper); });
  }
  ResultStore store_ = ResultStore::none("a test");
  StoredLevels levels_{store_, made_up_level};
  Bench bench_{.budget = Budget::quick, .route = {}, .levels = levels_, .store = store_};
};

TEST_F(OnABench, EveryCellHasALabelAndAVerdict) {
  const Paper paper = paper_of(std::string(head) + cells);
  EXPECT_THAT(cell_labels(paper, paper.claims.at(0)),
              ElementsAre("table_9.n12.node_error", "table_9.n48.node_error", "table_9.n48.node_ratio"));
  const auto reports = check(paper);
  ASSERT_EQ(reports.size(), 3U);
  for (const ClaimReport& report : reports) {
    EXPECT_EQ(report.found, Verdict::reproduced) << report.label;
    EXPECT_TRUE(report.as_recorded());
  }
  EXPECT_EQ(reports[2].printed, "4.0");
  EXPECT_EQ(reports[2].ours->value, 4);
}

TEST_F(OnABench, ACellThatDisagreesIsContradicted) {
  const auto reports = check(
      paper_of(std::string(head) + cells, {{"table_9.csv", "n,error,ratio\n12,1.0E0,\n48,2.5E-2,4.0\n"}}));
  EXPECT_EQ(reports[0].found, Verdict::reproduced);
  EXPECT_EQ(reports[1].found, Verdict::contradicted);
  EXPECT_FALSE(reports[1].as_recorded());
  EXPECT_EQ(reports[2].found, Verdict::reproduced);
}

TEST_F(OnABench, AVerdictBetterThanTheRecordDiffers) {
  std::string text = std::string(head) + cells;
  text.replace(text.find("\"reproduced\""), 12, "\"undecided\"");
  const auto reports = check(paper_of(text));
  EXPECT_EQ(reports[0].found, Verdict::reproduced);
  EXPECT_FALSE(reports[0].as_recorded());
}

TEST_F(OnABench, AControlThatFitsFailsTheCells) {
  const auto reports =
      check(paper_of(std::string(head) + cells, {{"control.json", problem_file("1/6", "0")}}));
  for (const ClaimReport& report : reports) EXPECT_EQ(report.found, Verdict::failed) << report.label;
}

TEST_F(OnABench, ASecondRouteThatDisagreesLeavesTheCellUndecided) {
  std::string text = std::string(head) + cells;
  text.replace(text.find("node_ratio.verdict"), std::string("node_ratio.verdict").size(),
               "node_ratio.second_route = true\nnode_ratio.verdict");
  const auto by = [&](double factor) {
    return check(paper_of(text), [factor](const Bench&, const Problem& p, int level, const std::string&) {
      return Approximation{
          .value = (level == 0 ? factor : 1) * made_up_level(p, level).result.node_error->value,
          .radius = 1e-12};
    })[2];
  };
  EXPECT_EQ(by(1).found, Verdict::reproduced);
  EXPECT_EQ(by(1.001).found, Verdict::undecided);
  EXPECT_EQ(check(paper_of(text))[2].found, Verdict::failed);  // there is no second route
}

TEST_F(OnABench, ARecordIsAskedForInBothDirections) {
  EXPECT_THAT(refusal(paper_of(std::string(head) + "[table_9.n12]\nnode_error.verdict = \"reproduced\"\n")),
              HasSubstr("/table_9.n48.node_error: is missing"));
  EXPECT_THAT(
      refusal(paper_of(std::string(head) + cells + "[table_9.n12.node_ratio]\nverdict = \"reproduced\"\n")),
      HasSubstr("/table_9.n12.node_ratio: is a verdict for a cell that the table does not print"));
}

TEST_F(OnABench, FilesThatDoNotFitAreRefused) {
  const std::string good = std::string(head) + cells;
  EXPECT_THAT(refusal(paper_of(good, {{"table_9.csv", "n,error\n12,1.0E0\n"}})),
              HasSubstr("\"ratio\" is no column"));
  EXPECT_THAT(refusal(paper_of(good, {{"table_9.csv", "n,error,ratio\n12,1.0E0\n"}})), HasSubstr("line 2"));
  EXPECT_THAT(refusal(paper_of(good, {{"table_9.csv", "n,error,ratio\n12,1.OE0,\n48,2.5E-1,4.0\n"}})),
              HasSubstr("\"1.OE0\""));
  EXPECT_THAT(refusal(paper_of(good, {{"problem.json", problem_file("1/6", "0")}})),
              HasSubstr("no level of 48 elements"));
  EXPECT_THAT(refusal(paper_of(good, {{"control.json", problem_file("1/10", "3")}})),
              HasSubstr("is no level of the table"));
  EXPECT_THAT(refusal(paper_of(good, {{"problem.json", "{"}})), HasSubstr("own/problem.json"));
}

TEST(Ratio, EnclosesTheQuotientsOfAllNumbersWithinTheRadii) {
  const Approximation a{.value = 3, .radius = 0.25};
  const Approximation b{.value = 2, .radius = 0.5};
  const Approximation quotient = ratio(a, b);
  EXPECT_EQ(quotient.value, 1.5);
  for (const double x : {2.75, 3.25})
    for (const double y : {1.5, 2.5}) EXPECT_LE(std::abs(x / y - quotient.value), quotient.radius);
  EXPECT_LT(quotient.radius, 0.7);
  EXPECT_FALSE(std::isfinite(ratio(a, {.value = 0.25, .radius = 0.5}).radius));
}

TEST(RunVerification, RunsOnAfterACheckThatThrows) {
  ResultStore store = ResultStore::none("a test");
  StoredLevels levels(store, made_up_level);
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  Selected own{paper_of("[a]\nsays = \"a\"\nverdict = \"certified\"\nscope = \"all\"\n[b]\nsays = "
                        "\"b\"\nverdict = \"certified\"\nscope = \"all\"\n"
                        "[c]\nsays = \"c\"\nverdict = \"unchecked\"\n"),
               {}};
  const std::vector<PaperChecks> checks{
      {.key = "own",
       .checks = {{"a", [](const Bench&) -> Finding { throw std::runtime_error("out of luck"); }},
                  {"b",
                   [](const Bench&) {
                     Finding finding;
                     finding.require("1/2", IsExactly{Rational(1, 2)}, Rational(1, 2));
                     finding.control("1/3", IsExactly{Rational(1, 2)}, Rational(1, 3));
                     return finding;
                   }}},
       .second_route = {}}};
  std::vector<Selected> selected;
  selected.push_back(own);
  const Report report = run_verification(selected, bench, checks);
  ASSERT_EQ(report.claims.size(), 3U);
  EXPECT_EQ(report.claims[0].found, Verdict::failed);
  EXPECT_EQ(report.claims[0].failure, "out of luck");
  EXPECT_EQ(report.claims[1].found, Verdict::certified);
  EXPECT_TRUE(report.claims[2].as_recorded());
  EXPECT_EQ(report.differing(), 1U);
}

TEST(RunVerification, RefusesAClaimWithoutACheck) {
  ResultStore store = ResultStore::none("a test");
  StoredLevels levels(store, made_up_level);
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  std::vector<Selected> selected;
  selected.push_back({paper_of("[a]\nsays = \"a\"\nverdict = \"certified\"\nscope = \"all\"\n"), {}});
  EXPECT_THROW(static_cast<void>(run_verification(selected, bench, {})), InputError);
}

TEST(RunVerification, JudgesAnOrderWithoutCode) {
  ResultStore store = ResultStore::none("a test");
  // Errors that halve for alpha = 1/10 and fall by 16 otherwise.
  StoredLevels levels(store, [](const Problem& problem, int level) {
    LevelOutcome outcome = made_up_level(problem, level);
    const double rate = triangle_basis_of(problem.method).alpha == Rational(1, 10) ? 1 : 4;
    outcome.result.node_error->value = std::exp2(-rate * level);
    return outcome;
  });
  const Bench bench{.budget = Budget::quick, .route = {}, .levels = levels, .store = store};
  const std::string claim =
      "[a]\nsays = \"a\"\ncheck = \"order\"\nproblem = \"problem.json\"\ncontrol = \"control.json\"\n"
      "quantity = \"node_error\"\norder = 4\nverdict = \"supported\"\n";
  const auto run = [&](const std::map<std::string, std::string>& files) {
    std::vector<Selected> selected;
    selected.push_back({paper_of(claim, files), {}});
    return run_verification(selected, bench, {}).claims.at(0).found;
  };
  const std::string fast = problem_file("1/6", "0, 1, 2, 3");
  const std::string slow = problem_file("1/10", "0, 1, 2, 3");
  EXPECT_EQ(run({{"problem.json", fast}, {"control.json", slow}}), Verdict::supported);
  EXPECT_EQ(run({{"problem.json", slow}, {"control.json", slow}}), Verdict::contradicted);
  EXPECT_EQ(run({{"problem.json", fast}, {"control.json", fast}}), Verdict::failed);
  for (const char* too_few : {"0, 1", "0, 1, 3", "2"})
    EXPECT_THROW(
        static_cast<void>(run({{"problem.json", problem_file("1/6", too_few)}, {"control.json", slow}})),
        InputError)
        << too_few;
}

}  // namespace
}  // namespace radcert::verification
