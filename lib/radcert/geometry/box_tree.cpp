// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/box_tree.h"

#include <numeric>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

double coordinate(const Vector<double>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

std::size_t widest_axis(const BoundingBox& box) {
  const Vector<double> width = box.high - box.low;
  if (width.x >= width.y && width.x >= width.z) return 0;
  return width.y >= width.z ? 1 : 2;
}

std::vector<Vector<double>> middles(const std::vector<BoundingBox>& boxes) {
  std::vector<Vector<double>> points;
  points.reserve(boxes.size());
  for (const BoundingBox& box : boxes) points.push_back(0.5 * box.low + 0.5 * box.high);
  return points;
}

}  // namespace

std::vector<BoundingBox> triangle_boxes(const TriangleMesh& mesh) {
  std::vector<BoundingBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) boxes.push_back(box_about(mesh.corners(k)));
  return boxes;
}

BoxTree::BoxTree(std::vector<BoundingBox> boxes) : BoxTree(boxes, middles(boxes)) {}

BoxTree::BoxTree(std::vector<BoundingBox> boxes, std::span<const Vector<double>> points,
                 std::size_t leaf_size)
    : boxes_(std::move(boxes)), order_(boxes_.size()) {
  expects(points.size() == boxes_.size(), "a point for each box", named("points", points.size()),
          named("boxes", boxes_.size()));
  expects(leaf_size >= 1, "leaf_size >= 1");
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!order_.empty()) build(points, leaf_size, 0, order_.size());
  std::vector<BoundingBox> in_order;
  in_order.reserve(boxes_.size());
  for (const std::size_t k : order_) in_order.push_back(boxes_[k]);
  boxes_ = std::move(in_order);
}

const BoundingBox& BoxTree::box() const {
  expects(!nodes_.empty(), "at least one box");
  return nodes_.front().box;
}

// While it builds, boxes_ stands in the order that it was given in.
void BoxTree::build(std::span<const Vector<double>> points, std::size_t leaf_size, std::size_t begin,
                    std::size_t end) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  BoundingBox box = boxes_[order_[begin]];
  BoundingBox of_points{points[order_[begin]], points[order_[begin]]};
  for (std::size_t i = begin; i < end; ++i) {
    box = hull(box, boxes_[order_[i]]);
    of_points = box_about(std::array{of_points.low, of_points.high, points[order_[i]]});
  }
  nodes_[at].box = box;
  const std::size_t leaves = (end - begin + leaf_size - 1) / leaf_size;
  if (leaves == 1) {
    nodes_[at].begin = begin;
    nodes_[at].end = end;
  } else {
    const std::size_t axis = widest_axis(of_points);
    const std::size_t half = begin + leaves / 2 * leaf_size;
    const auto first = order_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(half),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::size_t a, std::size_t b) {
                       const double left = coordinate(points[a], axis);
                       const double right = coordinate(points[b], axis);
                       return left != right ? left < right : a < b;
                     });
    build(points, leaf_size, begin, half);
    build(points, leaf_size, half, end);
  }
  nodes_[at].next = nodes_.size();
}

}  // namespace radcert
