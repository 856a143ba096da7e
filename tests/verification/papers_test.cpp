// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_reader.h"
#include "tests/core/refusal.h"
#include "tests/verification/fixtures.h"
#include "verification/framework/check.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/reading/toml_document.h"
#include "verification/framework/run_verification.h"

namespace radcert::verification {
namespace {

using testing::HasSubstr;

// The last numbered equation, and the pages, of each paper; [m06]'s page numbers are not known here.
struct Pages {
  int first;
  int last;
};
struct Extent {
  int last_equation;
  std::optional<Pages> pages;
};
const std::map<std::string, Extent>& extents() {
  static const std::map<std::string, Extent> all{{"ac98", {96, Pages{253, 290}}},
                                                 {"m06", {39, std::nullopt}},
                                                 {"psg10", {25, std::nullopt}},
                                                 {"radcert", {0, std::nullopt}}};
  return all;
}

std::string refusal(const std::vector<std::string>& words) {
  return test::refusal_of([&] { return select(words); });
}

TEST(Papers, CoverEquationsThatExist) {
  for (const Paper& paper : embedded_paper_list()) {
    ASSERT_TRUE(extents().contains(paper.key)) << paper.key;
    const Extent& extent = extents().at(paper.key);
    for (const Claim& claim : paper.claims) {
      const std::set<int> different(claim.covers.begin(), claim.covers.end());
      EXPECT_EQ(different.size(), claim.covers.size()) << claim.label;
      for (const int equation : claim.covers)
        EXPECT_TRUE(1 <= equation && equation <= extent.last_equation) << claim.label;
      ASSERT_EQ(claim.page.has_value(), extent.pages.has_value()) << claim.label;
      if (!extent.pages) continue;
      EXPECT_TRUE(extent.pages->first <= *claim.page && *claim.page <= extent.pages->last) << claim.label;
    }
  }
}

// Lemmas, theorems, corollaries and tables, by what the labels of their entries begin with; Theorem 4.1 of
// ac98 is its (82).
const std::map<std::string, std::vector<std::string>>& named_statements() {
  static const std::map<std::string, std::vector<std::string>> all{
      {"ac98", {"lemma_2_1",   "corollary_2_2", "lemma_2_3",     "theorem_2_4", "theorem_3_1",
                "lemma_3_2",   "lemma_3_3",     "corollary_3_4", "lemma_3_5",   "theorem_3_6",
                "theorem_3_7", "equation_82",   "theorem_4_2",   "section_4_2", "section_5_1",
                "table_1",     "table_2",       "table_3",       "table_4",     "table_5"}},
      {"m06",
       {"lemma_1", "lemma_2", "theorem_3", "theorem_4", "lemma_5", "lemma_6", "theorem_7", "lemma_8",
        "theorem_9"}},
      {"psg10",
       {"figure_3", "figure_5", "figure_6", "figure_7", "figure_8", "figure_9", "figure_10", "figure_11",
        "figure_12", "figure_13", "conclusion"}},
      {"radcert", {"edge_symbol", "edge_exponents"}}};
  return all;
}

// Every sentence that asserts something has an entry, or a reason why it has none; every entry answers for a
// sentence, or is said to be our own.
TEST(Papers, HoldTheirSentencesAndTheirEntriesTogether) {
  for (const Paper& paper : embedded_paper_list()) {
    std::set<std::string> labels;
    for (const Claim& claim : paper.claims) labels.insert(claim.label);
    const std::string file = std::string(RADCERT_SOURCE_DIR) + "/papers/" + paper.key + "/sentences.toml";
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const TomlDocument document = parse_toml(text, file);
    const JsonReader root(document.value);
    std::set<std::string> used;
    const auto take_entries = [&](const JsonReader& place) {
      for (const JsonReader& entry : place.elements("labels")) {
        const std::string& label = entry.string("a label");
        EXPECT_TRUE(labels.contains(label)) << file << ", " << entry.pointer() << ": " << label;
        used.insert(label);
      }
    };
    for (const JsonReader& sentence : root.at("sentence", "sentences").elements("sentences")) {
      sentence.require_object({"section", "page", "says", "entry", "reason"});
      EXPECT_FALSE(sentence.at("section", "a section").string("a section").empty());
      EXPECT_FALSE(sentence.at("says", "what it asserts").string("a text").empty());
      const auto entry = sentence.find("entry");
      EXPECT_NE(entry.has_value(), sentence.find("reason").has_value()) << file << ", " << sentence.pointer();
      if (entry) take_entries(*entry);
    }
    if (const auto own = root.find("own"))
      for (const JsonReader& statement : own->elements("statements of our own"))
        take_entries(statement.at("entry", "labels"));
    for (const std::string& label : labels)
      EXPECT_TRUE(used.contains(label)) << paper.key << "/" << label << " stands in no entry of " << file;
  }
}

TEST(Papers, HaveAnEntryForEachNumberedStatement) {
  for (const Paper& paper : embedded_paper_list()) {
    std::set<int> covered;
    for (const Claim& claim : paper.claims) covered.insert(claim.covers.begin(), claim.covers.end());
    for (int equation = 1; equation <= extents().at(paper.key).last_equation; ++equation)
      EXPECT_TRUE(covered.contains(equation)) << paper.key << " (" << equation << ")";
    for (const std::string& name : named_statements().at(paper.key))
      EXPECT_TRUE(std::any_of(paper.claims.begin(), paper.claims.end(),
                              [&](const Claim& claim) {
                                return claim.label == name || claim.label.starts_with(name + "_") ||
                                       claim.label.starts_with(name + ".");
                              }))
          << paper.key << " " << name;
  }
}

TEST(Papers, LeaveNoStatementUnchecked) {
  for (const Paper& paper : embedded_paper_list()) {
    for (const Claim& claim : paper.claims) {
      if (!claim.verdict) continue;
      for (const Budget budget : all_budgets)
        EXPECT_NE(claim.verdict->at(budget), Verdict::unchecked) << paper.key << " " << claim.label;
    }
  }
}

TEST(Papers, HaveLabelsOfTheirOwnAndACheckForEachAndNoOther) {
  const std::vector<PaperChecks> checks = all_checks();
  for (const Paper& paper : embedded_paper_list()) {
    std::vector<std::string> labels =
        statement_labels(paper);  // throws where a table and its cells do not match
    std::sort(labels.begin(), labels.end());
    EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end()) << paper.key;
    const auto of_paper =
        std::find_if(checks.begin(), checks.end(), [&](const PaperChecks& c) { return c.key == paper.key; });
    std::set<std::string> with_function;
    for (const Claim& claim : paper.claims)
      if (claim.check == CheckKind::function) with_function.insert(claim.label);
    std::set<std::string> registered;
    if (of_paper != checks.end()) {
      for (const auto& [label, check] : of_paper->checks)
        EXPECT_TRUE(registered.insert(label).second) << label;
    }
    EXPECT_EQ(with_function, registered) << paper.key;
  }
  for (const PaperChecks& each : checks) {
    const std::vector<Paper> papers = embedded_paper_list();
    EXPECT_TRUE(std::any_of(papers.begin(), papers.end(), [&](const Paper& p) { return p.key == each.key; }))
        << each.key;
  }
}

// The reader of a statement finds its line of the errata.
TEST(Papers, NameErrataThatAreThere) {
  for (const Paper& paper : embedded_paper_list())
    for (const Claim& claim : paper.claims) {
      if (claim.erratum.empty()) continue;
      EXPECT_THAT(paper.file("errata.md"), HasSubstr("\n| " + claim.erratum + " |")) << claim.label;
    }
}

TEST(Papers, HaveAnErratumForEachContradiction) {
  for (const Paper& paper : embedded_paper_list())
    for (const Claim& claim : paper.claims) {
      if (!claim.verdict) continue;
      for (const Budget budget : all_budgets)
        if (claim.verdict->at(budget) == Verdict::contradicted) {
          EXPECT_FALSE(claim.erratum.empty()) << paper.key << "/" << claim.label;
        }
    }
}

// What holds for all has no sample, and leaves none of what the statement quantifies over unchecked.
TEST(Papers, LeaveNothingOutOfWhatHoldsForAll) {
  const std::regex part(
      R"(other (surfaces|bodies|points|data|levels|scenes|nodes|elements|planes|sets|places|alpha|[xrknm])\b)"
      R"(|(levels?|degrees?|[rknm]) (above|below)|more than (two|three|four|five|six))");
  for (const Paper& paper : embedded_paper_list())
    for (const Claim& claim : paper.claims) {
      if (claim.table || claim.scope != Scope::all) continue;
      EXPECT_TRUE(claim.tried.empty()) << paper.key << "/" << claim.label;
      EXPECT_FALSE(std::regex_search(claim.unchecked, part))
          << paper.key << "/" << claim.label << ": " << claim.unchecked;
    }
}

TEST(Papers, SayHowEachHypothesisIsMet) {
  for (const Paper& paper : embedded_paper_list())
    for (const Claim& claim : paper.claims)
      EXPECT_EQ(claim.met.size(), claim.needs.size()) << paper.key << "/" << claim.label;
}

// A cell that disagrees is decided by two computations and says what holds instead.
TEST(Papers, SayWhatHoldsWhereACellDisagrees) {
  for (const Paper& paper : embedded_paper_list())
    for (const Claim& claim : paper.claims) {
      if (!claim.table) continue;
      for (const CellRecord& cell : claim.table->cells)
        for (const Budget budget : all_budgets) {
          if (cell.verdict.at(budget) == Verdict::reproduced || cell.verdict.at(budget) == Verdict::certified)
            continue;
          EXPECT_FALSE(cell.note.empty()) << cell.label;
          EXPECT_TRUE(cell.second_route) << cell.label;
        }
    }
}

TEST(Selection, FindsPapersClaimsAndCells) {
  const std::vector<std::string> words{"ac98/table_4.n48", "ac98/lemma_2_1"};
  const std::vector<Selected> selected = select(words);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_TRUE(selected[0].wants("table_4.n48.discretisation_error"));
  EXPECT_TRUE(selected[0].wants_part_of("table_4"));
  EXPECT_TRUE(selected[0].wants("lemma_2_1"));
  EXPECT_FALSE(selected[0].wants("table_4.n12.discretisation_error"));
  EXPECT_FALSE(selected[0].wants("table_4.n480"));
  EXPECT_FALSE(selected[0].wants_part_of("table_5"));
  const std::vector<std::string> whole{"ac98/lemma_2_1", "ac98"};
  EXPECT_TRUE(select(whole).at(0).wants("table_5.n12.node_error"));
  EXPECT_EQ(select({}).size(), embedded_paper_list().size());
}

TEST(Selection, FindsAFolderOfTheUsersOwn) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "claims.toml") << "[a]\nsays = \"a\"\nverdict = \"unchecked\"\n";
  const std::vector<std::string> words{folder.path().string() + "/"};
  const std::vector<Selected> selected = select(words);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].paper.key, folder.path().filename().string());
  EXPECT_EQ(selected[0].paper.claims.at(0).label, "a");
}

TEST(Selection, RefusesWhatThereIsNot) {
  EXPECT_THAT(refusal({"ac99"}), HasSubstr("ac98"));
  EXPECT_THAT(refusal({"ac98/table_99"}), HasSubstr("did you mean table_1?"));
  EXPECT_THAT(refusal({"ac98/table"}), HasSubstr("is not a statement"));
  const test::TemporaryFolder empty;
  EXPECT_THAT(refusal({empty.path().string()}), HasSubstr("claims.toml"));
}

}  // namespace
}  // namespace radcert::verification
