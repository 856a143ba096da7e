// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// Defects of a mesh that its topology does not show.
/// Maths     crossing: pairs of triangles that have more in common than a shared side or vertex, overlapping
///           and equal ones included
/// Source    CGAL, exact predicates, boxes sorted in space
/// Result    exact for the given doubles, sorted. Vertices with equal coordinates count as shared. crossing
///           holds most_crossings pairs where there are more
/// Limits    degenerate triangles are left out of crossing
struct MeshDefects {
  /// A vertex, and an earlier one with its coordinates
  std::vector<std::pair<std::size_t, std::size_t>> duplicate_vertices;
  std::vector<std::size_t> unreferenced_vertices;
  std::vector<std::size_t> degenerate_triangles;  ///< corners on one line
  std::vector<std::pair<std::size_t, std::size_t>> crossing;
};

extern const WorkLimit most_crossings;

/// The defects of a mesh. Result as MeshDefects.
[[nodiscard]] MeshDefects mesh_defects(const TriangleMesh& mesh);

/// Pairs of triangles that have more in common than a shared side or vertex.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> crossing_triangles(const TriangleMesh& mesh,
                                                                                  std::size_t most);

}  // namespace radcert
