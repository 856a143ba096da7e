// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/certificate/polyhedron_certificate.h"

namespace radcert::certificate {

/// Whether no corner of the surface lies behind the plane of a face.
/// Requires  the first three corners of each face are not on a line
/// Result    exact
[[nodiscard]] bool is_convex(const PolyhedronCertificate& certificate);

/// Whether the faces are the whole boundary of a body, seen from the inside, convex or not.
/// Maths     (a) no face has corners on both sides of the plane of another one, and faces of one plane have
///           disjoint interiors: what another face has in common with a face lies in a line of its plane,
///           beyond or on its border, so that the interiors of faces meet no other face. (b) The directed
///           edges, cut at all corners that lie on them, cancel: the faces are a cycle. So a number w(x) is
///           defined off the faces, that of signed crossings of any ray from x which meets no edge, + where
///           it leaves through the front; it is 0 far away, is constant where no face is crossed, and falls
///           by 1 through the interior of a face from its front to its back. (c) w = 1 before each face, by
///           one ray from it. Hence V = 1 where the open segment meets no face is symmetric, and T 1 = 1
///           almost everywhere: almost every ray from a point before a face starts where w = 1, meets no
///           edge and leaves the bounded set where w is not 0; the first face that it meets has w = 1 on the
///           side of the ray, which is its front
/// Requires  each face is a strictly convex polygon in one plane
/// Result    exact; nothing where all of it holds. Refused as well where no ray in general position was found
[[nodiscard]] std::optional<Refusal> solid_fault(const PolyhedronCertificate& certificate);

}  // namespace radcert::certificate
