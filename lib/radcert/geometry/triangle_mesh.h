// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/vector.h"

namespace radcert {

/// The numbers of a triangle's vertices.
using VertexTriple = std::array<std::size_t, 3>;

/// A surface made of plane triangles.
/// Maths     the union of the triangles with these vertices; the cross product (v_2 - v_1) x (v_3 - v_1)
///           orients each
/// Requires  indices below vertices.size(), three different ones a triangle; group, face as long as triangles
/// Result    plain data; the doubles are the exact coordinates
/// Limits    says nothing of how the triangles fit together: see mesh_topology
struct TriangleMesh {
  std::vector<Vector<double>> vertices;
  std::vector<VertexTriple> triangles;
  std::vector<std::size_t> group;        ///< of each triangle, a place in group_names
  std::vector<std::string> group_names;  ///< at least one where there are triangles; "" for what has no name
  std::vector<std::size_t> face;         ///< of each triangle, the face of the file that it was cut from

  [[nodiscard]] std::array<Vector<double>, 3> corners(std::size_t triangle) const {
    const VertexTriple& t = triangles[triangle];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

}  // namespace radcert
