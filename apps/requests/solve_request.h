// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/study/study.h"
#include "requests/work.h"

namespace radcert::app {

/// What is computed of a problem: its levels, and what they say together.
struct Solution {
  Result result;
  std::vector<LevelOutcome> levels;
};

/// A problem solved over its levels, each taken from a store where it is finished already.
/// Requires  `source` names the problem in messages; a store as store_named has it
/// Result    as check, solve_level and collect
[[nodiscard]] Solution solved(const Problem& problem, const std::string& source, const std::string& store,
                              Progress& told);

}  // namespace radcert::app
