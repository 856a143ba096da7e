// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/study/study.h"

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
/// The same for any degree and inset.
[[nodiscard]] Problem known_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                                    const std::string& reflectivity, const std::string& solution, int degree,
                                    const Rational& alpha);
/// The same problem by the rule of the centroids.
[[nodiscard]] Problem by_centroids(Problem problem);

}  // namespace radcert::verification::ac98
