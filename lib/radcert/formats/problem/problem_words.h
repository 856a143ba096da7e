// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radcert/study/problem.h"

namespace radcert {

/// A part of a problem in words, for tables and legends.
/// Requires  a key of the file format radcert/problem/1 other than schema, else ContractViolation
/// Result    one entry a choice: {"inset of degree 1", "alpha 1/6"}, {"levels 0 1 2", "pattern published",
///           "grading 2"}; exact numbers as they are
/// Limits    for people: two parts may read the same. A key that the problem does not state has no words
[[nodiscard]] std::vector<std::string> part_words(const Problem& problem, std::string_view key);

}  // namespace radcert
