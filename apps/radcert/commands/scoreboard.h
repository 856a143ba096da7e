// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "command.h"

namespace radcert::app {

/// radcert experiment scoreboard: all methods on a few problems with known or enclosed solutions.
/// Maths     each method's levels on each problem with their errors, unknowns, memory and seconds, and the
///           frontier of those that nothing beats; see study/scoreboard.h
/// Source    scoreboard/entries.h has the methods and the problems
/// Requires  finest, the last level for linear functions of every problem, >= 1; none: that of the problem
/// Result    the table, and in the folder `out`, unless it is empty, scoreboard.json, .csv and .html,
///           timing.csv and the plots
ExitCode run_scoreboard(const Common& common, const std::string& out, std::optional<int> finest);

}  // namespace radcert::app
