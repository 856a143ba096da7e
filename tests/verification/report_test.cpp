// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "tests/verification/fixtures.h"
#include "verification/report/report_page.h"
#include "verification/report/report_text.h"

namespace radcert::verification {
namespace {

using testing::HasSubstr;

Report two_claims() {
  ClaimReport cell;
  cell.paper = "ac98";
  cell.label = "table_1.n4.node_error";
  cell.says = "a | table";
  cell.found = Verdict::contradicted;
  cell.recorded = Verdict::reproduced;
  cell.ours = Approximation{.value = 1.0352e-3, .radius = 1e-16};
  cell.printed = "1.04E-4";
  cell.seconds = 1.25;
  cell.evidence.push_back({.what = "by the pipeline",
                           .value = "1.0352e-3",
                           .radius = "1e-16",
                           .allowed = "1.04E-4",
                           .standing = Standing::violated,
                           .proved = false});
  ClaimReport lemma;
  lemma.paper = "ac98";
  lemma.label = "lemma_2_1";
  lemma.says = "Int G = pi";
  lemma.found = lemma.recorded = Verdict::supported;
  lemma.ours = Approximation{.value = 3, .radius = std::numeric_limits<double>::infinity()};
  return {.budget = Budget::quick, .claims = {cell, lemma}};
}

TEST(Report, ShowsEveryCellBesideOurs) {
  const std::string table = report_table(two_claims());
  EXPECT_THAT(table, HasSubstr("! ac98/table_1.n4.node_error  contradicted  reproduced  1.03520e-03"));
  EXPECT_THAT(table, HasSubstr("1.04E-4"));
  EXPECT_THAT(table, HasSubstr("1 differ from the record"));
}

// In the table, whether or not it is too narrow for a line a statement, in its counts, in Markdown, in JSON
// and in what the page is made of. A cell of a table is one number, and has none.
TEST(Report, SaysHowFarEachVerdictReaches) {
  Report report = two_claims();
  report.claims[0].account.scope = Scope::all;
  report.claims[1].account.scope = Scope::instances;
  report.claims[1].account.tried = {"cube", "sphere"};
  ClaimReport family = report.claims[1];
  family.label = "lemma_2_2";
  family.account.scope = Scope::family;
  family.account.tried = {"all ellipsoids"};
  report.claims.push_back(family);
  const std::string table = report_table(report, 500);
  EXPECT_THAT(table, HasSubstr("  supported, at 2 instances  supported"));
  EXPECT_THAT(table, HasSubstr("  supported, for a family    supported"));
  EXPECT_THAT(table, testing::Not(HasSubstr("contradicted, for all")));
  EXPECT_THAT(table, HasSubstr("2 supported (1 for a family, 1 at instances)"));
  EXPECT_THAT(report_table(report, 40), HasSubstr("ac98/lemma_2_1, at 2 instances\n"));
  const std::string markdown = report_markdown(report, "radcert verify");
  EXPECT_THAT(markdown, HasSubstr("| lemma_2_1 | supported, at 2 instances |"));
  EXPECT_THAT(markdown, HasSubstr("Tried: cube, sphere."));
  const std::string json = report_json_text(report, "radcert verify");
  EXPECT_THAT(json, HasSubstr("\"scope\": \"instances\""));
  EXPECT_THAT(json, HasSubstr("\"scope\": \"family\""));
  EXPECT_THAT(report_page(report, "radcert verify"), HasSubstr("all ellipsoids"));
}

TEST(Report, AsJsonIsTheSameApartFromSeconds) {
  Report slow = two_claims();
  slow.claims[0].seconds = 99;
  const auto without_timing = [](const Report& report) {
    const JsonValue document = parse_json(report_json_text(report, "radcert verify"), "a test");
    JsonValue out = JsonValue::object();
    for (const auto& [key, value] : *document.members())
      if (key != "timing") out.set(key, value);
    return out.compact();
  };
  EXPECT_EQ(without_timing(slow), without_timing(two_claims()));
  EXPECT_NE(report_json_text(slow, ""), report_json_text(two_claims(), ""));
  EXPECT_THAT(without_timing(slow), HasSubstr("\"as_recorded\": false"));
}

TEST(Report, AsJsonHasNullForWhatIsNotFinite) {
  const JsonValue document = parse_json(report_json_text(two_claims(), "radcert verify"), "a test");
  const JsonValue::Array& claims = *document.find("claims")->elements();
  EXPECT_TRUE(claims[1].find("ours")->is_null());
  EXPECT_EQ(claims[0].find("ours")->find("value")->number(), 1.0352e-3);
}

TEST(Report, HasItsFilesInAFolder) {
  const auto files = report_files(two_claims(), "a/b", "radcert verify --out a/b");
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].first, "a/b/report.json");
  EXPECT_EQ(files[0].second, report_json_text(two_claims(), "radcert verify --out a/b"));
  EXPECT_EQ(files[1].first, "a/b/report.md");
  EXPECT_THAT(files[1].second, HasSubstr("| table_1.n4.node_error | **contradicted** | reproduced |"));
  EXPECT_EQ(files[2].first, "a/b/report.html");
}

}  // namespace
}  // namespace radcert::verification
