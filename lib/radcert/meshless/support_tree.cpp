// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/support_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

double coordinate(const Vector<double>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

std::size_t widest_axis(const Vector<double>& width) {
  if (width.x >= width.y && width.x >= width.z) return 0;
  return width.y >= width.z ? 1 : 2;
}

/// About the ball, so much wider that no rounding of a distance, or of a normal's length, puts what is in the
/// ball outside.
BoundingBox box_about_ball(const Vector<double>& centre, double radius) {
  const double size = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
  const double width = radius * (1 + 0x1p-40) + size * 0x1p-50;
  const Vector<double> half{width, width, width};
  return {centre - half, centre + half};
}

}  // namespace

SupportTree::SupportTree(std::span<const Vector<double>> centres, std::span<const double> radii)
    : order_(centres.size()) {
  expects(centres.size() == radii.size(), "a radius for each centre", named("centres", centres.size()),
          named("radii", radii.size()));
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!order_.empty()) build(centres, radii, 0, order_.size());
}

void SupportTree::build(std::span<const Vector<double>> centres, std::span<const double> radii,
                        std::size_t begin, std::size_t end) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  BoundingBox box = box_about_ball(centres[order_[begin]], radii[order_[begin]]);
  BoundingBox of_centres{centres[order_[begin]], centres[order_[begin]]};
  for (std::size_t i = begin; i < end; ++i) {
    const Vector<double>& centre = centres[order_[i]];
    const BoundingBox here = box_about_ball(centre, radii[order_[i]]);
    box = box_about(std::array{box.low, box.high, here.low, here.high});
    of_centres = box_about(std::array{of_centres.low, of_centres.high, centre});
  }
  nodes_[at].box = box;
  nodes_[at].begin = begin;
  const std::size_t leaves = (end - begin + leaf_size - 1) / leaf_size;
  if (leaves <= 1) {
    nodes_[at].is_leaf = true;
  } else {
    // Whole leaves to the left: every leaf but the last begins at a multiple of leaf_size.
    const std::size_t axis = widest_axis(of_centres.high - of_centres.low);
    const std::size_t half = begin + leaves / 2 * leaf_size;
    const auto first = order_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(half),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::size_t a, std::size_t b) {
                       const double left = coordinate(centres[a], axis);
                       const double right = coordinate(centres[b], axis);
                       return left != right ? left < right : a < b;
                     });
    build(centres, radii, begin, half);
    build(centres, radii, half, end);
  }
  nodes_[at].next = nodes_.size();
}

}  // namespace radcert
