// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// A box along the axes, closed.
struct BoundingBox {
  Vector<double> low;
  Vector<double> high;
};

/// The smallest box about points; exact.
template <std::size_t count>
[[nodiscard]] BoundingBox box_about(const std::array<Vector<double>, count>& points) {
  BoundingBox box{points[0], points[0]};
  for (const Vector<double>& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

/// A tree of boxes about the triangles of a mesh, for questions that most boxes answer.
/// Maths     each node's box holds those below it; halves at the median of the widest side
/// Source    in place of CGAL's AABB_tree, which tests closed segments: it hides what ends on a triangle, or
///           must list all that is met
/// Requires  finite coordinates
/// Result    visit() shows every triangle whose box and all boxes above it `accept` lets pass, always in the
///           same order: the boxes are exact, so nothing is lost where accept refuses only what it may
/// Limits    decides nothing about the triangles themselves
class BoxTree {
public:
  explicit BoxTree(const TriangleMesh& mesh);

  /// accept(box) -> whether to look into it; found(triangle) -> whether to go on. Whether found never said
  /// no.
  template <class Accept, class Found>
  bool visit(Accept&& accept, Found&& found) const {
    for (std::size_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (!accept(node.box)) {
        k = node.next;
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (accept(boxes_[i]) && !found(triangles_[i])) return false;
      ++k;
    }
    return true;
  }

  /// About all triangles; ContractViolation where there are none.
  [[nodiscard]] const BoundingBox& box() const;

private:
  /// In the order of a walk, the first child behind its parent; `next` skips what is below. Leaves alone have
  /// triangles.
  struct Node {
    BoundingBox box;
    std::size_t next = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  void build(std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
  std::vector<BoundingBox> boxes_;      ///< of triangles_[i]
  std::vector<std::size_t> triangles_;  ///< in the order of the leaves
};

}  // namespace radcert
