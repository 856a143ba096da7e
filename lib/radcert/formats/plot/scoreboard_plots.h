// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/formats/plot/plot.h"
#include "radcert/study/errors/scoreboard.h"

namespace radcert {

/// A problem of a scoreboard: one error of all methods against one cost, the frontier as a thick line.
/// Requires  places in board_errors and board_costs
/// Result    a curve a method with a positive error at some level, in the order of the methods, numbered by
///           its place among all methods, so that a method has the same colour on every problem
/// Limits    errors of 0 are not shown
[[nodiscard]] Plot scoreboard_plot(const BoardProblem& problem, std::size_t error, std::size_t cost);

/// Of each problem its first error that is known, against each of unknowns and bytes: nothing of seconds.
/// Result    names "ellipsoid_max_error_against_unknowns"
[[nodiscard]] std::vector<NamedPlot> scoreboard_plots(const std::vector<BoardProblem>& problems);

}  // namespace radcert
