// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert::verification::ac98 {

/// The integrals of section 2.2 over the unit square, enclosed without an antiderivative.
/// Maths     D = (xi - x)^2 + eta^2 + z^2, Int_0^1 Int_0^1 ... dxi deta
/// Source    [ac98, (22)-(24)]
/// Result    plain data
struct UnitSquareIntegrals {
  Ball one;             ///< z eta / D^2
  Ball offset;          ///< z eta (xi - x) / D^2
  Ball distance;        ///< z eta^2 / D^2
  Ball inverse_square;  ///< z / D
};

/// The integrals by Gauss-Legendre rules on equal panels, with a bound of what is cut off.
/// Maths     panels of half-width h = 1/(2m), m = ceil(1/z), N points, one variable at a time, the other
///           real. Around a panel the ellipse with the semi-minor axis z/2 has rho = t + sqrt(t^2 + 1), t =
///           z/(2h). In it |Im| <= z/2, so that |D| >= Re D >= 3/4 z^2, and |xi - x|, |eta| <= |1 + z/2 + i
///           z/2| < 1.6: no integrand exceeds M = 5 z^-3. A rule is off by at most twice the length 2h times
///           the error 2 M rho^(1-2N)/(rho - 1) of the best polynomial of degree 2N - 1: over all panels 4 M
///           rho^(1-2N)/(rho - 1) for one variable, 8 for both
/// Source    Trefethen, Approximation Theory and Approximation Practice, Theorem 8.2, for the best polynomial
/// Requires  0 < x < 1, 0 < z < 1, certainly so; 1 <= points <= 64
/// Result    encloses the integrals for all x and z of the balls, to about N log2(rho)/2 bits where these are
///           points
/// Limits    (N/z)^2 evaluations
[[nodiscard]] UnitSquareIntegrals unit_square_integrals(const Ball& x, const Ball& z, int points);

/// The integral over a half-disk of radius r, by the same rules in rho.
/// Maths     pi Int_0^r z rho / (rho^2 + z^2) drho
/// Source    [ac98, (26)]
/// Requires  0 < r <= 1, 0 < z < 1, certainly so; 1 <= points <= 64
/// Result    encloses; the panels have the half-width r/(2m), m = ceil(1/z), and cut off pi 4 M
///           rho^(1-2N)/(rho - 1) at most
[[nodiscard]] Ball half_disk_integral(const Ball& radius, const Ball& z, int points);

}  // namespace radcert::verification::ac98
