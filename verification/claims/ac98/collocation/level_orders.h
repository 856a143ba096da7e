// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/claims/ac98/collocation/observed_order.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

/// An expression that holds on every piece.
[[nodiscard]] PiecewiseExpression on_all_pieces(const std::string& text);

/// A problem with piecewise linear interpolation at inset nodes, alpha = 1/6.
/// Maths     u_n of [ac98, (40)] on the exact surface
/// Source    [ac98, section 3.1]
/// Requires  names, parameters and expressions that the catalogue and the parser take
/// Result    without `solution` and `emission`, one of which the caller adds
[[nodiscard]] Problem linear_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                                     const std::string& reflectivity);
/// The same with u = `solution`, so that E = u - Ku.
[[nodiscard]] Problem linear_problem_with_solution(const std::string& surface,
                                                   std::vector<SurfaceParameter> parameters,
                                                   const std::string& reflectivity,
                                                   const std::string& solution);

/// One of the errors of a level.
using LevelError = std::optional<Approximation> LevelResult::*;

/// The exponent of an error between two levels.
/// Maths     log2(e_(level-1) / e_level), h being halved; the radius from those of both errors
/// Source    the columns "Ratio" of [ac98, Tables 1-5]
/// Requires  level >= 1, and the problem has that error
/// Result    infinite, which settles nothing, if an error is not clearly above zero
/// Limits    a radius that was not estimated counts as 0
[[nodiscard]] Approximation observed_order(LevelSource& levels, const Problem& problem, LevelError error,
                                           int level);

}  // namespace radcert::verification::ac98
