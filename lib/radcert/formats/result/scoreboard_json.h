// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/errors/scoreboard.h"

namespace radcert {

/// A scoreboard as JSON.
/// Source    the file format radcert/scoreboard/1
/// Result    a cell a problem and method, with its levels or why there are none. Seconds, and the frontiers
///           against them, live in `timing` alone: all else is the same to the bit on every run
[[nodiscard]] JsonValue scoreboard_json(std::span<const BoardProblem> problems, const std::string& command);

/// The same as CSV, without the seconds.
/// Source    the columns problem, method, level, unknowns, bytes, max_error, l2_error, mean_error, and for
///           each error and cost ERROR_COST_frontier; refused
/// Result    a row a level; one with `refused` alone for a method that cannot serve the problem
[[nodiscard]] std::string scoreboard_csv(std::span<const BoardProblem> problems);

/// The seconds: problem, method, level, seconds, and for each error ERROR_seconds_frontier.
[[nodiscard]] std::string scoreboard_timing_csv(std::span<const BoardProblem> problems);

}  // namespace radcert
