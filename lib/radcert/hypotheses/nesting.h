// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// The components of a closed mesh whose inner side is not the inside of a body.
/// Maths     with w(X) the sum of the components' winding numbers about X, counted so that a body has w = 1
///           inside and w = 0 outside: a component is at fault where w is not 1 on its inner side. A room
///           holds a box where the box's triangles run counterclockwise as seen from inside the box, those of
///           the room as seen from outside the room
/// Source    the winding number is the sum of the triangles' solid angles over 4 pi, each by van Oosterom and
///           Strackee, 1983
/// Requires  a closed mesh whose triangles agree and do not cross, touch or degenerate
/// Result    first triangles of the components at fault, ascending; empty: there is one inside, which all
///           inner normals point into. The sign of each solid angle is exact, and of their sum only the
///           nearest whole number counts
/// Limits    components times triangles, but for components whose box does not hold the other's vertex
[[nodiscard]] std::vector<std::size_t> misoriented_components(const TriangleMesh& mesh,
                                                              const MeshTopology& topology,
                                                              Orientation orientation);

}  // namespace radcert
