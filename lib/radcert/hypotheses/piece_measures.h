// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/scalar/approximation.h"

namespace radcert {

/// How large a piece of a mesh is, and where.
struct PieceMeasures {
  std::size_t triangles = 0;
  Approximation area = Approximation::exact(0);
  /// Of unit length, to the side of the cross product; none where its triangles lie in several planes
  std::optional<Vector<double>> normal;
  Vector<double> centroid;
  BoundingBox box;
};

/// The measures of each piece.
/// Maths     area: the sum of |(v_2 - v_1) x (v_3 - v_1)| / 2; centroid: the mean of the area
/// Requires  a piece below `pieces` for each triangle, each piece a triangle, none degenerate, else
///           ContractViolation
/// Result    areas enclosed, boxes exact; normals from the exact cross product, rounded; centroids rounded
[[nodiscard]] std::vector<PieceMeasures> piece_measures(const TriangleMesh& mesh,
                                                        std::span<const std::size_t> of_piece,
                                                        std::size_t pieces);

}  // namespace radcert
