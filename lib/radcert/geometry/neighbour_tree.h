// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "radcert/geometry/vector.h"

namespace radcert {

/// A k-d tree of points, for questions about nearest ones.
/// Maths     the points in the order of |p - x|
/// Source    CGAL, dD Spatial Searching: orthogonal incremental neighbour search
/// Requires  finite coordinates
/// Result    visit(place, squared distance) for one point after the other, nearest first, until it returns
///           false or all were visited. The order is that of the rounded squared distances, up to a factor 1
///           +- 2^-40; equally distant points come in an order of the tree's own
/// Limits    immutable; shared by threads
class NeighbourTree {
public:
  using Visit = std::function<bool(std::size_t place, double squared_distance)>;

  explicit NeighbourTree(std::span<const Vector<double>> points);
  ~NeighbourTree();
  NeighbourTree(NeighbourTree&&) noexcept;
  NeighbourTree& operator=(NeighbourTree&&) noexcept;

  void visit_by_distance(const Vector<double>& from, const Visit& visit) const;
  [[nodiscard]] std::size_t size() const;

private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace radcert
