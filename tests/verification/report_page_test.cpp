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

}  // namespace
}  // namespace radcert::verification
