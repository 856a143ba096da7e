// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert::verification::ac98 {

/// G on the roof z = 2 - x^p of two_piece(p), p = 2 or 3, and its derivatives by the parameters of P.
/// Maths     P = (x, y), Q = (xi, eta) in the parameters, d = xi - x, e = eta - y, A = bend_p
///           bend_q/(stretch_p stretch_q), D = d^2 chord + e^2:
///               G = A d^4/D^2,  G_y = 4 A d^4 e/D^3,  G_x = A_x d^4/D^2 - 4 A d^3 e^2/D^3 - 2 A d^6
///               chord_x/D^3, G_xy = 4 e [A_x d^4/D^3 + A (-4 d^3/D^3 + 6 d^5 chord/D^4 - 3 d^6 chord_x/D^4)]
/// Source    [ac98, (2), (94)], roof_pair.h
/// Requires  P != Q
/// Result    enclosed
struct RoofKernel {
  Ball g;
  Ball by_x;
  Ball by_y;
  Ball by_x_and_y;
};
[[nodiscard]] RoofKernel roof_kernel(int p, const Ball& x, const Ball& xi, const Ball& e);

/// Bounds of these derivatives over all pairs of points of the roof.
/// Maths     with d = r cos, e = r sin, r <= 2^(1/2): D/r^2 = cos^2 chord + sin^2 >= 1, |cos^3 sin^2| <= 1/4,
///           |cos^4 sin| <= 1/2, and cos^2 chord <= D/r^2, so that
///               r |G_x| <= 2^(1/2) (a' + 2 c) + a,   r |G_y| <= 2 a,   r^2 |G_xy| <= 4 [2^(1/2) (a' + 3 c) +
///               10 a],
///           a, a' and c the largest of A, |A_x| and A |chord_x|. The first two hold for |P-Q| = D^(1/2) in
///           the place of r as well, as each term has the factor r^2/D twice at least, and for derivatives by
///           lengths along the roof, which are shorter
/// Result    upper bounds, by balls on boxes; first: of r (|G_x| + |G_y|), second: of r^2 |G_xy|
struct KernelDerivativeBounds {
  Ball first;
  Ball second;
};
[[nodiscard]] KernelDerivativeBounds roof_derivative_bounds(int p);

/// A bound of the derivatives of G by the parameters of P between the two pieces of two_piece(p), P on
/// either.
/// Maths     |G_x| + |G_y| <= the bound, for P on the square and for P on the roof
/// Result    an upper bound, by balls on boxes
[[nodiscard]] Ball derivative_bound_between_the_pieces(int p);

/// C with Int |G(P,Q) - G(P',Q)| dS_Q <= C |P - P'| for P and P' on one piece of two_piece(p), |P - P'| in
/// the parameters.
/// Maths     |G(P,Q) - G(P',Q)| is at most the integral of the gradient along the segment of parameters from
///           P to P', and the integral over Q of 1/r about a point of the unit square at most that over the
///           disk of the same area, 2 pi^(1/2). The area element is at most that at x = 1
/// Result    an upper bound
[[nodiscard]] Ball lipschitz_bound(int p);

}  // namespace radcert::verification::ac98
