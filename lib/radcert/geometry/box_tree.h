// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
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

/// The smallest box about two; exact.
[[nodiscard]] inline BoundingBox hull(const BoundingBox& a, const BoundingBox& b) {
  return box_about(std::array{a.low, a.high, b.low, b.high});
}

/// Whether two boxes have no point in common; exact.
[[nodiscard]] inline bool apart(const BoundingBox& a, const BoundingBox& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y ||
         a.high.z < b.low.z || b.high.z < a.low.z;
}

/// The box of each triangle of a mesh; exact.
[[nodiscard]] std::vector<BoundingBox> triangle_boxes(const TriangleMesh& mesh);

/// Where a tree parts what is below a node.
enum class TreeParting {
  middle,  ///< at the median of the points along the widest side of the box about them
  /// Of the places along each axis that leave both sides an eighth at least, where the sum over both halves
  /// of their number times the surface of their box is least: a line that meets a convex body meets one
  /// within it with the probability of the quotient of their surfaces, so that lines look into fewest boxes.
  least_surface,
};

/// A tree of boxes, for questions that most boxes answer.
/// Maths     each node's box holds those below it; what is below is parted as TreeParting says
/// Source    ours; why not CGAL's: see CONTRIBUTING.md; least_surface by Goldsmith & Salmon, 1987
/// Requires  finite points, as many as boxes; leaf_size >= 1
/// Result    leaves hold leaf_size numbers of boxes, the last one maybe fewer; order() has these numbers leaf
///           by leaf. Walks go through the leaves in this order. Boxes are exact, so nothing is lost where
///           accept refuses only what it may
/// Limits    decides nothing about what is in the boxes; immutable, shared by threads
class BoxTree {
public:
  static constexpr std::size_t usual_leaf_size = 4;

  BoxTree() = default;
  /// Boxes, and a point of each to part them by.
  BoxTree(std::vector<BoundingBox> boxes, std::span<const Vector<double>> points,
          std::size_t leaf_size = usual_leaf_size, TreeParting parting = TreeParting::middle);
  /// Boxes, and their middles as points; with least_surface a leaf for each.
  explicit BoxTree(std::vector<BoundingBox> boxes, TreeParting parting = TreeParting::middle);

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  /// About all boxes; ContractViolation where there are none.
  [[nodiscard]] const BoundingBox& box() const;

  /// accept(box) -> whether to look into it; leaf(begin, end) -> whether to go on, with places in order().
  /// Whether no leaf said no.
  template <class Accept, class Leaf>
  bool visit_leaves(Accept&& accept, Leaf&& leaf) const {
    for (std::size_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (!accept(node.box)) {
        k = node.next;
        continue;
      }
      if (node.begin < node.end && !leaf(node.begin, node.end)) return false;
      ++k;
    }
    return true;
  }

  /// accept(box) -> whether to look into it; found(number) -> whether to go on, for each box that accept lets
  /// pass with all above it. Whether found never said no.
  template <class Accept, class Found>
  bool visit(Accept&& accept, Found&& found) const {
    return visit_leaves(accept, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (accept(boxes_[i]) && !found(order_[i])) return false;
      return true;
    });
  }

  /// Looks for the number of the greatest value: upper(box) bounds the values in a box, look(number) returns
  /// the greatest value so far. Of two halves the one that promises more is looked into first, and none that
  /// promises no more than was found.
  template <class Upper, class Look>
  void search(double least, Upper&& upper, Look&& look) const {
    struct Pending {
      std::size_t node;
      double upper;
    };
    // Each level leaves one. A half has at most 7/8 of the leaves, rounded up, and 2 are parted into 1 and 1.
    std::array<Pending, 2 + most_levels> pending;
    std::size_t count = 0;
    if (!nodes_.empty()) pending[count++] = {0, upper(nodes_[0].box)};
    while (count > 0) {
      const Pending next = pending[--count];
      if (next.upper <= least) continue;
      const Node& node = nodes_[next.node];
      if (node.begin == node.end) {
        const std::size_t first = next.node + 1;
        const std::size_t second = nodes_[first].next;
        std::array<Pending, 2> halves{
            {{first, upper(nodes_[first].box)}, {second, upper(nodes_[second].box)}}};
        if (halves[0].upper > halves[1].upper) std::swap(halves[0], halves[1]);
        for (const Pending& half : halves) pending[count++] = half;
      }
      for (std::size_t i = node.begin; i < node.end; ++i) least = look(order_[i]);
    }
  }

private:
  /// In the order of a walk, the first child behind its parent; `next` skips what is below. Leaves alone have
  /// numbers, order_[begin], ..., order_[end - 1].
  struct Node {
    BoundingBox box;
    std::size_t next = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  struct Division;
  /// (8/7)^334 > 2^64, and rounding up adds a level for each of the numbers below 8.
  static constexpr std::size_t most_levels = 344;

  void build(const Division& division, std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
  std::vector<BoundingBox> boxes_;  ///< of order_[i]
  std::vector<std::size_t> order_;
};

}  // namespace radcert
