// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Requires that a ray from a point P of a face of a bounded convex polyhedron, off its edges, into the side
/// of its normal leaves the body once: for polyhedra with any number of faces, by induction on that.
/// Maths     the body is {l_i >= 0}, l_i affine, P with l_0(P) = 0 and l_i(P) = alpha_i > 0 for i > 0. Along
///           P + r w, r > 0, l_i is alpha_i + r s_i. R is the least alpha_i/(-s_i) of the s_i < 0 so far:
///           all l_i are positive for r < R, and one is negative for r > R. With one more face this holds
///           for the new R. As the body is bounded there is an R for each w with s_0 > 0: the one point of S
///           with r > 0 that the ray meets, at which both cosines are positive. Where s_0 <= 0, no l_0 is
///           positive: points of S there are in the plane of P, where G = 0
/// Source    ours
/// Result    exact. With require_kernel_by_directions: Int_S G(P,Q) dS_Q = pi and G >= 0
/// Limits    the logic about it is in words
void require_rays_leave_polyhedra_once(Finding& finding);

/// Requires that the segment between points P and Q of different faces of a convex polyhedron, off its edges,
/// is inside between its ends, for polyhedra with any number of faces, and that G = 0 for P and Q of one
/// face.
/// Maths     X = (1-t) P + t Q, 0 < t < 1: l(X) = (1-t) l(P) + t l(Q) for each affine l. The form of each
///           face is not negative at P and Q, and positive at one of them at least, as each is off the edges
///           and they have no face in common. Of one face: (Q-P).n_P is l(Q) - l(P) = 0 over the size of its
///           gradient
/// Source    ours
/// Result    exact: V = 1, or G V = G = 0
void require_segments_in_polyhedra(Finding& finding);

}  // namespace radcert::verification::ac98
