// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// The vertices of a mesh, for the question which lies farthest beyond a plane.
/// Requires  finite coordinates
/// Result    see farthest_beyond
/// Limits    holds copies of the points
class VertexTree {
public:
  VertexTree(std::span<const Vector<double>> points, std::vector<std::size_t> numbers);

  /// The vertex that lies farthest beyond the plane through a, b, c.
  /// Maths     beyond: orientation(a, b, c, v) > 0
  /// Requires  a, b, c not on one line
  /// Result    nothing exactly if no vertex is beyond. Which of several is farthest is decided up to rounding
  [[nodiscard]] std::optional<std::size_t> farthest_beyond(const Vector<double>& a, const Vector<double>& b,
                                                           const Vector<double>& c) const;

private:
  std::vector<Vector<double>> points_;
  std::vector<std::size_t> numbers_;  ///< of points_
  BoxTree tree_;
};

}  // namespace radcert
