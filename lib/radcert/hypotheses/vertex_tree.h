// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/geometry/vector.h"

namespace radcert {

/// The vertices of a mesh in a tree of boxes.
/// Maths     each node holds a box about its vertices; halves at the median of the widest side
/// Requires  finite coordinates
/// Result    see farthest_beyond
/// Limits    holds copies of the points
class VertexTree {
public:
  explicit VertexTree(const std::vector<Vector<double>>& points, std::vector<std::size_t> numbers);

  /// The vertex that lies farthest beyond the plane through a, b, c.
  /// Maths     beyond: orientation(a, b, c, v) > 0
  /// Requires  a, b, c not on one line
  /// Result    nothing exactly if no vertex is beyond. Which of several is farthest is decided up to rounding
  [[nodiscard]] std::optional<std::size_t> farthest_beyond(const Vector<double>& a, const Vector<double>& b,
                                                           const Vector<double>& c) const;

private:
  struct Node {
    Vector<double> low;
    Vector<double> high;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::array<std::size_t, 2> child{0, 0};  // 0: a leaf, for node 0 is nobody's child
  };
  std::size_t build(std::size_t begin, std::size_t end);

  std::vector<Vector<double>> points_;
  std::vector<std::size_t> numbers_;
  std::vector<Node> nodes_;
};

}  // namespace radcert
