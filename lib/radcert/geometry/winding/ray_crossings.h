// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A triangle that a ray passes through.
struct RayCrossing {
  std::size_t triangle;
  int side;  ///< 1 where the ray runs along its cross product, -1 where against it
};

/// A point inside a triangle, (2 a + b + c) / 4; exact.
[[nodiscard]] Vector<Rational> point_inside(const std::array<Vector<double>, 3>& corners);

/// The triangles that rays pass through, for winding numbers.
/// Maths     of closed triangles, those of a chain without boundary, the sides of the crossings of a ray from
///           X sum to the winding number about X, if the ray meets no side of a triangle. Of the rays along
///           (1, s, s^2) a plane through X holds two at most, and a ray that meets a side of a triangle lies
///           in the plane through X and that side: if X lies on no triangle, one of 6 n + 1 values of s does
///           not fail, n triangles
/// Source    ours; signs of 3 x 3 determinants in doubles with a bound, and in rational numbers where that
///           does not tell
/// Requires  the mesh outlives it
/// Result    exact. Degenerate triangles, which pass nothing, are left out
class RayCrossings {
public:
  explicit RayCrossings(const TriangleMesh& mesh);
  RayCrossings(const TriangleMesh& mesh, std::vector<std::size_t> triangles);

  /// What a ray from a point passes through; nothing where the point lies on a triangle.
  [[nodiscard]] std::optional<std::vector<RayCrossing>> from(const Vector<Rational>& point) const;

  /// What a ray passes through that leaves a triangle at point_inside, on the side of its cross product (1)
  /// or on the other (-1); triangles in its plane lie behind. Nothing where that point lies on a triangle of
  /// another plane.
  [[nodiscard]] std::optional<std::vector<RayCrossing>> from_side(std::size_t triangle, int side) const;

  /// About the triangles. Requires one at least.
  [[nodiscard]] const BoundingBox& box() const { return tree_.box(); }

private:
  const TriangleMesh& mesh_;
  std::vector<std::size_t> triangles_;
  BoxTree tree_;
};

/// The sum of the sides of crossings: see RayCrossings.
[[nodiscard]] long winding_number(const std::vector<RayCrossing>& crossings);

}  // namespace radcert
