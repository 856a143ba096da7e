// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Requires the bounds of both cosines, and of G, on all ellipsoids with half axes a <= b <= c, A =
/// diag(a^-2, b^-2, c^-2).
/// Maths     with Q = P + h, h = |h| e: (Q-P).n_P/|P-Q| = |h| e.Ae/(2 |AP|), as in require_convex_ellipsoids.
///           Here e.Ae <= 1/a^2 and |AP| >= 1/c, so that |cos theta_P| <= c/(2a^2) |P-Q| and 0 <= G <=
///           c^2/(4a^4): sums over the coordinates of terms that are not negative
/// Result    exact, for all half axes and points
void require_bounds_on_ellipsoids(Finding& finding);

/// Requires what the parts of the proof of Lemma 2.1 about a point P of an ellipsoid rest on, for all P, all
/// half axes a <= b <= c and all epsilon.
/// Maths     U = {Q inside, |Q-P| = epsilon}. Q = P + epsilon w with |w| = 1 is inside if and only if n_P.w
///           > epsilon w.Aw/(2 |AP|), as Q.AQ - P.AP = epsilon (2 w.AP + epsilon w.Aw) and n_P = -AP/|AP|.
///           By (11) Int_U G is the integral of n_P.w over these directions: pi, that of the half-sphere
///           n_P.w > 0, less at least 0 and at most that over the band 0 < n_P.w <= epsilon c/(2a^2), pi
///           (epsilon c/(2a^2))^2. T = {Q of S, |Q-P| <= epsilon}, 0 < epsilon <= a^2/(3c): with m = |AP| >=
///           1/c and s = |A(Q-P)| <= epsilon/a^2 <= m/3 the normals have n_P.n_Q >= (m^2 - m s)/(m (m + s))
///           >= 1/2. A line along n_P meets S twice at most, with opposite signs of n_P.n_Q, so that T
///           covers each point of the disk of radius epsilon in the plane of P once at most: its area is at
///           most 2 pi epsilon^2
/// Source    [ac98, (10)-(12)]
/// Result    exact, in three coordinates
/// Limits    in words: Cauchy's inequality, area as an integral over a projection, Int_0^s 2 pi t dt = pi s^2
void require_small_balls_on_ellipsoids(Finding& finding);

}  // namespace radcert::verification::ac98
