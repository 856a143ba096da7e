// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/certificate/polyhedron_certificate.h"

namespace radcert::certificate {

/// Whether the faces are the whole boundary of a body, seen from the inside.
/// Maths     each face is a strictly convex polygon in one plane. Where some corner lies behind a face:
///           solid_fault. Else some corner lies before each. So each lies in a facet of the hull K of all
///           corners, which is the hull of the corners in its plane. The faces of one plane have disjoint
///           interiors and the area of that facet, and each directed edge of a facet is that of another one
///           reversed: the facets of a polytope are connected over their edges, so that none is missing. Then
///           V = 1, T is symmetric and not negative, and T 1 = 1 almost everywhere
/// Result    exact; nothing where all of it holds
[[nodiscard]] std::optional<Refusal> surface_fault(const PolyhedronCertificate& certificate);

/// Whether 0 <= rho <= what is stated < 1 on every face: lies_within.
[[nodiscard]] std::optional<Refusal> reflectivity_fault(const PolyhedronCertificate& certificate);

/// Whether the elements cover the sectors of all faces, each point but borders once.
/// Maths     boxes in [0,1]^2 without common interior points whose areas sum to 1
/// Result    exact
[[nodiscard]] std::optional<Refusal> tiling_fault(const PolyhedronCertificate& certificate);

}  // namespace radcert::certificate
