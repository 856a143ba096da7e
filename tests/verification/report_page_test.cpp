// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace radcert::verification {
namespace {

using testing::HasSubstr;
using testing::Not;

Report report_that_says(const std::string& words) {
  ClaimReport claim;
  claim.paper = "own";
  claim.label = "one";
  claim.says = words;
  claim.found = claim.recorded = Verdict::supported;
  claim.account.formula = "a < b";
  return {.budget = Budget::quick, .claims = {claim}};
}

// Whatever a claim says, it stays text: it neither ends the element that holds it nor begins another.
TEST(ReportPage, KeepsWordsFromBecomingMarkup) {
  const std::string page =
      report_page(report_that_says("</script><img src=x><!-- a & b"), "radcert verify <there>");
  EXPECT_THAT(page, Not(HasSubstr("</script><img")));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x>")));
  EXPECT_THAT(page, Not(HasSubstr("<there>")));
}

TEST(ReportPage, IsOneFileThatFetchesNothing) {
  const std::string page = report_page(report_that_says("Int G = pi"), "radcert verify");
  EXPECT_THAT(page, HasSubstr("Int G = pi"));
  for (const char* const outside : {"src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  if (!has_full_page()) {
    EXPECT_THAT(page, HasSubstr("built without Node"));
  }
}

// One element, u - u_n = 1/2 at its only node: a Float32Array of it in base 64, and of the three corners
// painted with it.
TEST(ReportPage, PaintsElementsWithTheErrorAtTheirNodes) {
  Report report = report_that_says("u_n is near u");
  ProblemTrace problem;
  problem.name = "one element";
  problem.text = "{}";
  ElementValue element;
  element.corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  element.corner_values = {1, 1, 1};
  problem.elements = {element};
  NodeValue node;
  node.point = {0.25, 0.25, 0};
  node.normal = {0, 0, 1};
  node.u_n = Approximation::exact(1);
  node.u = 1.5;
  problem.nodes = {node};
  report.problems = {problem};
  if (!has_full_page()) GTEST_SKIP() << "the plain page has no pictures";
  const std::string page = report_page(report, "radcert verify");
  EXPECT_THAT(page, HasSubstr("\"AAAAPw==\""));
  EXPECT_THAT(page, HasSubstr("\"AAAAPwAAAD8AAAA/\""));
}

}  // namespace
}  // namespace radcert::verification
