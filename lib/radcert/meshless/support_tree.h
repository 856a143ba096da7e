// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// Balls about points, in leaves of as many as a Pack has lanes, for the question which of them hold a point.
/// Maths     a tree of boxes about the balls; halves at the median of the widest side
/// Requires  as many radii as centres, radii >= 0 or infinite, finite centres
/// Result    order() puts balls that are near each other together; visit_leaves shows every leaf with a ball
///           that holds the point, by the first of its up to leaf_size places in that order, and others.
///           Boxes are widened by 2^-40 of the radius, so that rounding hides none
/// Limits    decides nothing about the balls themselves
class SupportTree {
public:
  static constexpr std::size_t leaf_size = 8;

  SupportTree() = default;
  SupportTree(std::span<const Vector<double>> centres, std::span<const double> radii);

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

  template <class Leaf>
  void visit_leaves(const Vector<double>& p, const Leaf& leaf) const {
    for (std::size_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      const bool inside = node.box.low.x <= p.x && p.x <= node.box.high.x && node.box.low.y <= p.y &&
                          p.y <= node.box.high.y && node.box.low.z <= p.z && p.z <= node.box.high.z;
      if (!inside) {
        k = node.next;
        continue;
      }
      if (node.is_leaf) leaf(node.begin);
      ++k;
    }
  }

private:
  /// In the order of a walk, the first child behind its parent; `next` skips what is below.
  struct Node {
    BoundingBox box;
    std::size_t next = 0;
    std::size_t begin = 0;
    bool is_leaf = false;
  };
  void build(std::span<const Vector<double>> centres, std::span<const double> radii, std::size_t begin,
             std::size_t end);

  std::vector<Node> nodes_;
  std::vector<std::size_t> order_;
};

}  // namespace radcert
