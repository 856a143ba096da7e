// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The coordinate to which a grading moves that of a vertex.
/// Maths     c -> (2c)^grading / 2 for c <= 1/2, else 1 - (2 (1 - c))^grading / 2
/// Source    [ac98, section 6]
/// Requires  0 <= c <= 1, grading >= 1
/// Result    rounded: see grading_in_double
[[nodiscard]] double graded_coordinate(double c, double grading);

/// What double holds of the vertices of a graded triangulation.
enum class GradingInDouble {
  exact,    ///< each vertex is that of the grading
  rounded,  ///< they are those of the grading, rounded; every layer has its width to 2^-20 of it
  blurred   ///< rounding may change the width of the layers next to the far ends by more than that
};

/// What triangulate makes of a grading at a level.
/// Maths     the coordinates of vertices are those to which c = k/2^level is moved. The narrowest layers, at
///           both ends, have the width w = 2^-(q (level - 1) + 1). From level 2 on c = 1/4 is among them,
///           whose image is irrational unless q is whole; if it is, all coordinates are multiples of w, and
///           doubles where w >= 2^-53. A coordinate beyond 1/2 is rounded by 2^-54 at most, so that
///           w >= 2^-33 keeps the outermost layers to 2^-21 of w, and the others, which are wider, to 2^-20
/// Source    ours
/// Requires  level >= 0, grading >= 1, else ContractViolation
/// Result    exact only where each double was compared; exact too where the surface has no unit squares
/// Limits    that what is `rounded` is no worse takes the C library's power to be right to an ulp
[[nodiscard]] GradingInDouble grading_in_double(const Surface& surface, const Rational& grading, int level);

/// The width of the narrowest layers of a graded unit square: 2^-(grading (level - 1) + 1), 1 at level 0.
/// Result    rounded; 0 where double has nothing so small
[[nodiscard]] double narrowest_layer(const Rational& grading, int level);

}  // namespace radcert
