// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "radcert/core/outcome.h"
#include "radcert/study/study.h"

namespace radcert {

/// A finished level as text, for the result store.
/// Maths     read_level_record(level_record(x)) = x to the bit, seconds included
/// Source    ours; not a file format for others
/// Requires  finite numbers, else ContractViolation
/// Result    JSON on one line
/// Limits    read back by the same version only: the key of the store says which
std::string level_record(const LevelOutcome& level);

/// The level of such a text, or why the text is none.
Outcome<LevelOutcome> read_level_record(std::string_view text);

/// The key under which a level of a problem is stored.
/// Requires  a problem that problem_json can write
/// Result    the digest of the sources, the canonical problem without its other levels, the level: everything
///           that the level's numbers depend on
/// Limits    two spellings of one problem ("0.5" and "1/2" in an expression) have two keys
std::string level_key(const Problem& problem, int level);

}  // namespace radcert
