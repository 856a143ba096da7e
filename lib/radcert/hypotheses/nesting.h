// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// Where the light of a closed mesh is taken to be.
enum class LightOf {
  rooms,     ///< within bodies
  the_open,  ///< around bodies, as if a room held them all
};

/// The components of a mesh without boundary on whose inner side there is no light.
/// Maths     with w(X) the winding number of the mesh about X, counted so that a body whose inner normals
///           point inwards has w = 1 inside and w = 0 outside; of the_open w is 1 more everywhere: a
///           component is at fault where w is not 1 on its inner side. A room holds a box where the box's
///           triangles run counterclockwise as seen from inside the box, those of the room as seen from
///           outside the room. Proof that one triangle of a component tells: on the inner side of a triangle
///           w is one number, since no other triangle is there; next to an edge of two triangles that agree
///           nothing else is, so that the inner sides of both are connected beside it; and the triangles of a
///           component are connected through such edges. What touches it in a vertex, or along an edge, which
///           has more than two triangles then and connects nothing, changes nothing in that. If all inner
///           sides have w = 1, a ray that begins there arrives at the inner side of what it meets
/// Source    crossings of a ray with their signs: see RayCrossings
/// Requires  along each edge as many triangles run one way as the other; equal coordinates are one vertex;
///           two triangles have a side or a vertex in common, nothing, or all, being the two sides of a plate
/// Result    first triangles of the components at fault, ascending; empty: all inner normals point to where
///           the light is. Exact; refused where each triangle of a component has a point on another across
///           it, which crosses it then
[[nodiscard]] Outcome<std::vector<std::size_t>> misoriented_components(const TriangleMesh& mesh,
                                                                       const MeshTopology& topology,
                                                                       Orientation orientation,
                                                                       LightOf light);

/// The number of components of a closed mesh that lie in no other.
/// Maths     components about whose points no other component winds: by the proof of misoriented_components
///           one point off the others tells
/// Requires  as misoriented_components, and no edge of more than two triangles, so that each component is
///           without boundary
/// Result    exact; refused as there
[[nodiscard]] Outcome<std::size_t> outermost_components(const TriangleMesh& mesh,
                                                        const MeshTopology& topology);

}  // namespace radcert
