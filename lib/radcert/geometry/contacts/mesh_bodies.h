// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// The bodies and rooms that the triangles of a mesh bound.
/// Maths     around an edge of more than two triangles, two that stand one behind the other with nothing but
///           the backs of both between them bound one solid there; the others bound nothing. component:
///           triangles that are connected through edges of two or through such pairs. A component is closed
///           where each side of its triangles is connected so, to one that runs the other way
/// Source    ours
/// Requires  no degenerate triangle. right_hand: the front is the side from which the corners run
///           counterclockwise
/// Result    by the vertices' numbers, exact
/// Limits    pairs are right where no two triangles around an edge look the same way from one plane
struct MeshBodies {
  std::vector<std::size_t> component;  ///< of each triangle
  std::vector<bool> is_body;           ///< of each component: closed, with its front outside
  std::vector<bool> is_room;           ///< closed, with its front inside
};

/// The bodies and rooms of a mesh. Requires and result as MeshBodies.
[[nodiscard]] MeshBodies mesh_bodies(const TriangleMesh& mesh, bool right_hand);

}  // namespace radcert
