// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report_junit.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "radcert/formats/plot/svg_elements.h"
#include "radcert/scalar/enclosing_text.h"
#include "verification/report/report_text.h"

namespace radcert::verification {

namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + svg::escaped(value) + "\"";
}

std::string seconds(double value) { return nearest_text(value, DecimalForm::fixed(3)); }

/// A text between tags, its lines kept.
std::string lines(std::string_view text) {
  std::string out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    out += svg::escaped(text.substr(begin, end - begin)) + (end < text.size() ? "\n" : "");
    begin = end + 1;
  }
  return out;
}

bool is_error(const ClaimReport& claim) { return claim.failure || claim.found == Verdict::failed; }

/// How many cases of a suite are so.
struct Counts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  double seconds = 0;

  void add(const ClaimReport& claim) {
    ++tests;
    if (is_error(claim))
      ++errors;
    else if (!claim.as_recorded())
      ++failures;
    seconds += claim.seconds;
  }
  [[nodiscard]] std::string attributes() const {
    return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
           attribute("errors", std::to_string(errors)) +
           attribute("time", radcert::verification::seconds(seconds));
  }
};

std::string difference(const ClaimReport& claim) {
  return std::string(name(claim.found)) + ", recorded is " + std::string(name(claim.recorded));
}

std::string evidence_lines(const ClaimReport& claim) {
  std::string out;
  if (claim.failure) out += *claim.failure + "\n";
  for (const Evidence& evidence : claim.evidence)
    out += evidence.what + ": " + observed_text(evidence) + "; allowed " + evidence.allowed + "; " +
           std::string(name(evidence.standing)) + "\n";
  return out;
}

std::string test_case(const ClaimReport& claim) {
  std::string out = "    <testcase" + attribute("classname", claim.paper) + attribute("name", claim.label) +
                    attribute("time", seconds(claim.seconds)) + ">\n";
  if (is_error(claim))
    out += "      <error" + attribute("type", "failed") + attribute("message", difference(claim)) + ">" +
           lines(evidence_lines(claim)) + "</error>\n";
  else if (!claim.as_recorded())
    out += "      <failure" + attribute("type", "verdict") + attribute("message", difference(claim)) + ">" +
           lines(evidence_lines(claim)) + "</failure>\n";
  out += "      <system-out>" +
         lines(claim.says + "\nverdict: " + std::string(name(claim.found)) + "\n" + evidence_lines(claim)) +
         "</system-out>\n    </testcase>\n";
  return out;
}

}  // namespace

std::string report_junit(const Report& report) {
  std::vector<std::string> papers;
  Counts all;
  for (const ClaimReport& claim : report.claims) {
    all.add(claim);
    if (std::find(papers.begin(), papers.end(), claim.paper) == papers.end()) papers.push_back(claim.paper);
  }
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                    attribute("name", "radcert verify") + all.attributes() + ">\n";
  for (const std::string& paper : papers) {
    Counts counts;
    std::string cases;
    for (const ClaimReport& claim : report.claims) {
      if (claim.paper != paper) continue;
      counts.add(claim);
      cases += test_case(claim);
    }
    out +=
        "  <testsuite" + attribute("name", paper) + counts.attributes() + ">\n" + cases + "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace radcert::verification
