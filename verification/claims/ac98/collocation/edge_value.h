// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/study/study.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

/// The equation on the two squares (20) for constant reflectivity and E = 1, with linear interpolation, alpha
/// = 1/6.
[[nodiscard]] Problem constant_emission_on_two_squares(const Rational& reflectivity, const Rational& grading);

/// Its solution on the common edge.
/// Maths     lim u(x,0,z) as z -> 0, 0 < x < 1, is 1/(1 - rho/2): K takes a function with the limit g on the
///           edge to one with the limit (rho/pi) (pi/2) g, the first term of (22), and u = 1 + K 1 + K^2 1 +
///           ... converges uniformly
/// Source    [ac98, (22)]
/// Requires  0 <= rho < 2
/// Result    exact
/// Limits    not at the ends of the edge, where the limit of u depends on the direction
[[nodiscard]] inline Rational solution_on_the_edge(const Rational& reflectivity) {
  return 1 / (1 - reflectivity / 2);
}

/// How far u_n is from that value on the common edge.
/// Maths     midpoint: the largest |u_n - u| at (1/2,0,0) over the elements that have this vertex; anywhere:
///           the same over all vertices of elements on the edge but its ends. Each is a lower bound of the
///           norm of u - u_n
/// Requires  a level >= 1 of the problem
/// Result    the radius covers rounding and the tolerance of the matrix
struct EdgeError {
  Approximation at_midpoint{.value = 0, .radius = 0};
  Approximation anywhere{.value = 0, .radius = 0};
};
[[nodiscard]] EdgeError edge_error(const LevelOutcome& level, const Rational& reflectivity);

/// The exponent b of r^b, by which u behaves beside a right-angled edge.
/// Maths     (rho/4) B((b+2)/2, (1-b)/2) = 1
/// Source    radcert reference edge_exponent_90
/// Requires  0 < rho < 2
/// Result    within 1e-8
[[nodiscard]] double edge_exponent(const Rational& reflectivity);

}  // namespace radcert::verification::ac98
