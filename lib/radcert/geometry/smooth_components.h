// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// A line of a mesh along which smooth components end or meet.
struct SharpLine {
  std::vector<std::size_t> vertices;  ///< one after the other; those of a closed line without repetition
  bool closed = false;
  bool open_border = false;  ///< its edges have one side
};

/// A mesh, cut along its sharp edges.
/// Maths     an edge is sharp where the normals of its two triangles make an angle beyond the given one;
///           edges with one side or more than two end components as well. A corner is a vertex where sharp
///           edges do not number two, or two turn beyond the angle
/// Source    the pieces S_j of [ac98, (13)]
/// Requires  0 <= degrees <= 180; no degenerate triangle
/// Result    components in the order of their first triangles; lines run from corner to corner or are closed.
///           Each angle is compared exactly with the one whose cosine is the double nearest that of the given
///           angle
/// Limits    smooth is meant of the surface that the mesh was made for: the components themselves stay flat
///           triangles
struct SmoothComponents {
  std::vector<std::size_t> of_triangle;
  std::size_t count = 0;
  /// Of each triangle: the components cut along the borders of groups as well
  std::vector<std::size_t> of_piece;
  std::size_t piece_count = 0;
  std::vector<std::size_t> sharp_edges;  ///< of the topology
  std::vector<SharpLine> lines;
  std::vector<std::size_t> corners;
};

/// The parts of a mesh between its sharp edges, `topology` its own. Requires and result as SmoothComponents.
[[nodiscard]] SmoothComponents smooth_components(const TriangleMesh& mesh, const MeshTopology& topology,
                                                 double degrees);

/// Names for the pieces: that of the group where the piece is all of it, else with a number; piece_1, ...
/// without groups.
[[nodiscard]] std::vector<std::string> piece_names(const TriangleMesh& mesh,
                                                   const SmoothComponents& components);

}  // namespace radcert
