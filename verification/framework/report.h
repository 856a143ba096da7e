// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "verification/framework/finding.h"
#include "verification/framework/problem_trace.h"
#include "verification/framework/verdict.h"

namespace radcert::verification {

/// What claims.toml tells the reader of a statement beside its words.
struct Account {
  std::string formula;             ///< in TeX
  std::vector<std::string> met;    ///< how each hypothesis is met where it was checked; empty: not said
  std::optional<Scope> scope;      ///< how far the verdict reaches; absent where nothing is checked
  std::vector<std::string> tried;  ///< the instances, or the family
  std::string unchecked;           ///< what the evidence does not reach
  std::string erratum;             ///< the place of its line in errata.md
};

/// What a run found of one statement, or of one cell of a table.
/// Result    plain data; the same on every run, but for `seconds`
struct ClaimReport {
  std::string paper;
  std::string label;
  std::string says;
  std::vector<int> covers;
  std::optional<int> page;
  std::vector<std::string> needs;
  Verdict found = Verdict::unchecked;
  Verdict recorded = Verdict::unchecked;
  std::optional<Approximation> ours;
  std::optional<std::string> printed;  ///< of a cell
  std::string note;                    ///< from claims.toml
  std::vector<Evidence> evidence;
  std::vector<std::string> remarks;
  std::optional<std::string> failure;  ///< what a check threw
  Account account = {};
  std::vector<std::size_t> problems =
      {};  ///< those of Report::problems that its check solved, in the order of use
  double seconds = 0;

  /// The verdict is the recorded one, neither worse nor better.
  [[nodiscard]] bool as_recorded() const { return found == recorded && found != Verdict::failed; }
};

/// What a paper's folder says beside its claims; empty where it has no such file.
struct PaperText {
  std::string key;
  std::string folder;  ///< as the user named it; empty: a paper inside the program
  std::string readme;
  std::string errata;
};

/// What a run found.
struct Report {
  Budget budget = Budget::quick;
  std::vector<ClaimReport> claims;
  std::vector<ProblemTrace> problems = {};
  std::vector<PaperText> papers = {};

  [[nodiscard]] std::size_t differing() const {
    std::size_t count = 0;
    for (const ClaimReport& claim : claims) count += claim.as_recorded() ? 0 : 1;
    return count;
  }
  [[nodiscard]] bool as_recorded() const { return differing() == 0; }
};

}  // namespace radcert::verification
