// SPDX-License-Identifier: GPL-3.0-or-later

// By directions: G dS_Q = n_P.w dw for Q = P + r w, so that Int_S G is the integral of n_P.w over those
// directions in which a point of S is seen, each taken once. On the boundary of a bounded convex body each w
// with n_P.w > 0 meets S in one point, as the ray leaves the body once, and no other w does, so that the
// integral is pi, for every P at which S is smooth.
//
// Checked      G dS_Q = n_P.w dw, an identity. That each w with n_P.w > 0 meets S once, and G >= 0: on all
//              ellipsoids, for all P and Q, as identities; on all convex polyhedra, for all P off the edges,
//              by induction on the faces. On four polyhedra another way: the sum of Lambert's angles,
//              face_angles.h; a body without a face is rejected.
// Not checked  other bodies, but by the first lines; that the body is bounded is not printed, see equation_7.

#include "verification/claims/ac98/convex_bodies/convex_polyhedra.h"
#include "verification/claims/ac98/surfaces/face_angles.h"
#include "verification/claims/ac98/surfaces/solid_angle.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding lemma_2_1(const Bench&) {
  Finding finding;
  require_kernel_by_directions(finding);
  require_convex_ellipsoids(finding);
  require_rays_leave_polyhedra_once(finding);
  for (const Polyhedron& body : {cube_polyhedron(), box_polyhedron(1, 2, 5), tetrahedron(), octahedron()})
    require_total_of_pi(finding, body);
  return finding;
}

}  // namespace radcert::verification::ac98
