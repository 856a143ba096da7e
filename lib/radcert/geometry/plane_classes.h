// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// Which triangles lie in one plane and look the same way.
/// Maths     a ~ b where the planes are equal as sets and the normals (v_2 - v_1) x (v_3 - v_1) have the same
///           direction
/// Requires  no degenerate triangle, else ContractViolation
/// Result    of_triangle[t] is a number below count; numbered in the order in which triangles first show
///           them; exact. In n log n steps
struct PlaneClasses {
  std::vector<std::size_t> of_triangle;
  std::vector<std::size_t> first_triangle;  ///< of each class
  [[nodiscard]] std::size_t count() const { return first_triangle.size(); }
};

/// The classes of the triangles of a mesh. Requires and result as PlaneClasses.
[[nodiscard]] PlaneClasses plane_classes(const TriangleMesh& mesh);

}  // namespace radcert
