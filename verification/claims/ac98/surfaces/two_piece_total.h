// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// The largest of Int_S G(P,Q) dS_Q over all points P of one piece of two_piece(p).
/// Maths     With Q = (xi, y + v, .) every part of the integrand is N(x, xi)/(A + v^2)^2, N >= 0, A > 0: even
///           in v and falling with |v|, so that of all P with the same x the one with y = 1/2 has the largest
///           integral, 2 N times Int_0^(1/2) dv/(A + v^2)^2 = V/(2A(A + V^2)) + atan(V/sqrt A)/(2 A^(3/2)), V
///           = 1/2. What is left is an integral over xi: square to roof  N = z (z + p xi^(p-1) (xi - x)), A =
///           (xi - x)^2 + z^2, z = 2 - xi^p; roof to square  N = z (z - p x^(p-1) (xi - x))/stretch_p, z = 2
///           - x^p, A = (xi - x)^2 + z^2; roof to roof    N = d^4 bend_p bend_q/stretch_p, A = d^2 chord, see
///           RoofPair: smooth on either side of xi = x
/// Source    [ac98, (2), (94)]; the integral is that of radcert's reference values for the lower piece, typed
///           in here once more
/// Requires  p >= 2 a whole number
/// Result    enclosed by branch and bound over 0 <= x <= 1; largest_*: the maximum, total_*: at one x, y =
///           1/2
[[nodiscard]] Ball largest_total_of_square(int p, double radius);
[[nodiscard]] Ball largest_total_of_roof(int p, double radius);
[[nodiscard]] Ball total_of_square(int p, const Rational& x, double radius);
[[nodiscard]] Ball total_of_roof(int p, const Rational& x, double radius);

/// max over the roof of the integral over the roof alone, and the least over both pieces of the integral over
/// S from the points with y = 1/2, of which half, as N/(A + v^2)^2 falls with |v|, bounds it for all y.
[[nodiscard]] Ball largest_roof_to_roof(int p, double radius);
[[nodiscard]] Ball least_total_in_the_middle(int p, double radius);

/// sup_P Int_S G = pi times the norm of K for rho = 1.
[[nodiscard]] Ball largest_total(int p, double radius);

}  // namespace radcert::verification::ac98
