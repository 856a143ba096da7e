// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Requires that G dS_Q is the cosine at P times the element of the sphere of directions.
/// Maths     Q = P + r w with |w| = 1, w and r functions of two parameters: det(Q_1, Q_2, w) = r^2 det(w_1,
///           w_2, w). The left is +- cos theta_Q dS over the element of the parameters, and r^2 dw the right,
///           so that G dS_Q = cos theta_P cos theta_Q dS_Q/r^2 = n_P.w dw. So Int_S G <= pi where every w
///           with n_P.w > 0 meets S in one point with G != 0 at most, and = pi where it meets S in one: the
///           half-sphere n_P.w > 0 has the disk of radius 1 as its projection
/// Source    [ac98, (2), (7)]
/// Result    exact, for all w, r and their derivatives: the determinants are linear in (r_1, w_1) and in
///           (r_2, w_2), and of degree 3 in w, 2 in r
void require_kernel_by_directions(Finding& finding);

/// Requires what the ellipsoids with half axes a_1, a_2, a_3 have for all their points P, Q, A =
/// diag(a_i^-2).
/// Maths     with h = Q - P:  h.AP + h.Ah/2 = (Q.AQ - P.AP)/2, so that (Q-P).n_P = h.Ah/(2 |AP|) > 0 on the
///           ellipsoid, where n_P = -AP/|AP|: both cosines are positive. The line P + r w meets it at r = 0
///           and r = -2 w.AP/w.Aw alone, which is positive if and only if n_P.w is. The segment is inside
///           between its ends: with X = (1-t) P + t Q, X.AX = 1 - t(1-t) h.Ah. Each identity is a sum over
///           the coordinates
/// Result    exact, for all half axes and points
void require_convex_ellipsoids(Finding& finding);

}  // namespace radcert::verification::ac98
