// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/study/study.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification {

/// The equation of a cube whose solution is not known and whose means are enclosed.
/// Maths     rho = 2/5, E = (1 - z)^4: in C(S), and on each face a polynomial
/// Result    by collocation of degree r at the nodes of inset alpha
[[nodiscard]] Problem quartic_emission_on_the_cube(int degree, const Rational& alpha);

/// The mean over the floor of the solution itself.
/// Source    reference/continuous_means.h: a certificate, in which all but the claims is proved again here
/// Result    proved if the claims of the file are: radcert check --all
[[nodiscard]] Ball mean_over_the_floor();

/// How far the means of u_n over the floor are from a number.
/// Result    radii are those of u_n's mean, which are estimates, and the number's
[[nodiscard]] LevelErrors floor_errors(const Bench& bench, const Problem& problem, const Ball& mean,
                                       const std::vector<int>& levels);

/// The exponent b of r^b, by which u behaves beside a right-angled edge.
/// Maths     (rho/4) B((b+2)/2, (1-b)/2) = 1
/// Result    within 1e-8
[[nodiscard]] double exponent_beside_right_angles(const Rational& reflectivity);

}  // namespace radcert::verification
