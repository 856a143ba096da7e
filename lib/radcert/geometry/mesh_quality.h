// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// Sizes and shapes of a mesh's triangles.
/// Maths     angles in degrees; aspect = longest side / (2 sqrt(3) times the radius of the inscribed circle),
///           1 for equal sides
/// Requires  at least one triangle
/// Result    rounded; degenerate triangles count for sides and diagonal only
/// Limits    for people
struct MeshQuality {
  double area = 0;
  double shortest_side = 0;
  double longest_side = 0;
  double smallest_angle = 180;
  double largest_angle = 0;
  double largest_aspect = 1;
  std::size_t worst_triangle = 0;  ///< that of largest_aspect
  double diagonal = 0;             ///< of the box about the triangles' vertices
};

/// The sizes and shapes of a mesh. Requires and result as MeshQuality.
[[nodiscard]] MeshQuality mesh_quality(const TriangleMesh& mesh);

}  // namespace radcert
