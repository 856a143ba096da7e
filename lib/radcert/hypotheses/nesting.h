// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// Where the light of a closed mesh is taken to be.
enum class LightOf {
  rooms,     ///< within bodies
  the_open,  ///< around bodies, as if a room held them all
};

/// The components of a closed mesh on whose inner side there is no light.
/// Maths     with w(X) the sum of the components' winding numbers about X, counted so that a body whose inner
///           normals point inwards has w = 1 inside and w = 0 outside; of the_open w is 1 more everywhere: a
///           component is at fault where w is not 1 on its inner side. A room holds a box where the box's
///           triangles run counterclockwise as seen from inside the box, those of the room as seen from
///           outside the room
/// Source    the winding number is the sum of the triangles' solid angles over 4 pi, each by van Oosterom and
///           Strackee, 1983
/// Requires  a closed mesh whose triangles agree and do not cross, touch or degenerate
/// Result    first triangles of the components at fault, ascending; empty: all inner normals point to where
///           the light is. The sign of each solid angle is exact, and of their sum only the nearest whole
///           number counts
/// Limits    components times triangles, but for components whose box does not hold the other's vertex
[[nodiscard]] std::vector<std::size_t> misoriented_components(const TriangleMesh& mesh,
                                                              const MeshTopology& topology,
                                                              Orientation orientation, LightOf light);

/// The number of components of a closed mesh that lie in no other.
/// Maths     components about whose points no other component winds
/// Requires  a closed mesh whose triangles do not cross, touch or degenerate
[[nodiscard]] std::size_t outermost_components(const TriangleMesh& mesh, const MeshTopology& topology);

}  // namespace radcert
