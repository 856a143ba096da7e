// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Requires what makes Int_S G(P,Q) dS_Q = pi for every P of a convex polyhedron off its edges, and G >= 0.
/// Maths     Lambert: with the corners of a face in the sense of its inner normal, Int_face G = -(1/2) sum
///           over its sides ab of their angle at P times n_P.nu, nu the unit vector along (a-P) x (b-P); the
///           face must lie in front of the plane of P. A side that is in no common plane with P's face occurs
///           twice, once in each sense, and cancels. A side ab of P's own face f occurs once as ba: there
///           (a-P) x (b-P) is along n_P, as P is inside f, and the angles are together 2 pi, as f is convex.
///           So Int_S G = 2 pi/2
/// Source    J. H. Lambert, Photometria (1760); ours
/// Result    exact: corners behind a face, sides without the opposite side, and corners where a face does not
///           turn to the left, are none
void require_total_of_pi(Finding& finding, const Polyhedron& polyhedron);

/// Directed sides ab of faces which are not exactly once there as ba.
[[nodiscard]] Rational sides_without_opposite(const Polyhedron& polyhedron);

}  // namespace radcert::verification::ac98
