// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "verification/framework/check.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/report.h"

namespace radcert::verification {

/// The statement that a run is about to check.
struct Progress {
  std::string statement;  ///< "ac98/lemma_2_1"
  std::size_t done = 0;
  std::size_t total = 0;  ///< statements and cells that were asked for
};

/// The labels of a paper's statements, tables cell by cell.
/// Result    in the order of claims.toml; InputError where a table and its records do not match
[[nodiscard]] std::vector<std::string> statement_labels(const Paper& paper);

/// Runs the checks of what was selected and holds each verdict against the record.
/// Requires  the bench outlives the call
/// Result    a report a statement, in the order of claims.toml; where the store keeps something, checks in
///           code run beside each other before the others. A check that throws gives `failed` and what
///           it said, and the others run on; InputError, EnvironmentError and Interrupted leave. Everything
///           that was solved before stays in the store
[[nodiscard]] Report run_verification(std::span<const Selected> selected, const Bench& bench,
                                      std::span<const PaperChecks> checks,
                                      const std::function<void(const Progress&)>& progress = {});

/// The same for the words of a command line, with the checks that radcert has.
[[nodiscard]] Report run_verification(std::span<const std::string> words, const Bench& bench,
                                      const std::function<void(const Progress&)>& progress = {});

}  // namespace radcert::verification
