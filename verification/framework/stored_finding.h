// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "verification/framework/check.h"
#include "verification/framework/problem_trace.h"

namespace radcert::verification {

/// What a check has found, and how long it took when it was computed.
struct TimedFinding {
  Finding finding;
  double seconds = 0;
};

/// What a check that is compiled in has found, computed once and kept.
/// Requires  `name` is the statement's, "ac98/lemma_2_1"; the bench solves by `levels`, where the check has
///           not begun; the check depends on the bench's budget and on radcert's own sources alone
/// Result    the finding to the bit, from the store or from check(bench), then stored unless its verdict is
///           `failed`. Of a stored one the levels that it had asked for are asked for again, so that
///           `levels` records the same problems
[[nodiscard]] TimedFinding stored_finding(const Check& check, const std::string& name, const Bench& bench,
                                          RecordedLevels& levels);

/// Whether the finding of that statement is kept.
[[nodiscard]] bool is_stored(const std::string& name, const Bench& bench);

}  // namespace radcert::verification
