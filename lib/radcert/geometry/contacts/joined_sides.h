// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// A mesh without corners that lie on sides of other triangles.
struct JoinedSides {
  TriangleMesh mesh;
  std::size_t cut = 0;  ///< triangles that had such corners on their sides
};

/// Cuts triangles where corners of others lie on their sides: what touches along a part of a side meets side
/// by side then.
/// Maths     a triangle with points on its sides is a polygon with straight angles; it is triangulated by
///           these points and its corners. As a set it is what it was
/// Source    polygon_triangles
/// Requires  no degenerate triangle
/// Result    exact; vertices with equal coordinates count as one, and of these a side takes the first. A
///           triangle that is cut leaves its first part in its place, the others stand behind all that were
///           there, with its group and face
/// Limits    corners inside of triangles, and sides that cross, stay as they are
[[nodiscard]] JoinedSides joined_sides(TriangleMesh mesh);

}  // namespace radcert
