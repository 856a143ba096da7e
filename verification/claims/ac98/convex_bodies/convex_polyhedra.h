// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Requires that a ray from a point P of a face of a bounded convex polyhedron, off its edges, into the side
///          of
/// its normal leaves the body once: for polyhedra with any number of faces, by induction on that.
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

}  // namespace radcert::verification::ac98
