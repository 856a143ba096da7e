// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// The repairs of a mesh, each made only where it is asked for.
struct MeshRepair {
  bool align = false;  ///< turn the file's faces to the axes and make rounded coordinates equal: aligned
  bool triangulate = false;  ///< cut faces of the file whose corners do not lie in one plane: see BentFaces
  bool vertices = false;     ///< join vertices with equal coordinates, leave out those that no triangle uses
  bool faces = false;        ///< leave out degenerate triangles and all but the first of equal ones
  bool orientation = false;  ///< turn the fewest triangles that make neighbours agree
  bool manifold = false;     ///< part the surface at edges with more than two sides and at pinched vertices
  /// Leave out every triangle that crosses or overlaps another; `holes` then closes what that opens
  bool crossings = false;
  bool holes = false;  ///< close every line of open edges with triangles
};

/// The words for it, in the order of the members.
inline constexpr std::array<std::string_view, 8> repair_words{
    "align", "triangulate", "vertices", "faces", "orientation", "manifold", "crossings", "holes"};

/// The choice of these words; ContractViolation for any other.
[[nodiscard]] MeshRepair repair_named(std::span<const std::string> words);

/// Mends a mesh, and says what was done.
/// Maths     in the order of MeshRepair's members from `vertices` on; `align` and `triangulate` come before
///           there is a mesh of triangles
/// Source    holes: CGAL's triangulate_hole_polyline
/// Result    the mended mesh; done: one line for each thing that was changed, empty where nothing was
/// Limits    triangles that close a hole may cross others again: look at the defects afterwards. A part of a
///           surface that is not orientable is left as it is. Where a degenerate triangle is left out, its
///           neighbours may no longer meet: look at the open edges
struct MendedMesh {
  TriangleMesh mesh;
  std::vector<std::string> done;
};

/// The mesh with what was asked for mended. Result as MendedMesh.
[[nodiscard]] MendedMesh mend(TriangleMesh mesh, const MeshRepair& repair);

/// Triangles that close a line of open edges: places in `line`, turned as `line` runs; none where CGAL finds
/// none.
[[nodiscard]] std::vector<VertexTriple> hole_triangles(const std::vector<Vector<double>>& line);

}  // namespace radcert
