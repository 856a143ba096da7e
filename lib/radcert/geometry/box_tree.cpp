// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/box_tree.h"

#include <numeric>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

// Few enough that looking at each costs no more than the boxes that would part them.
constexpr std::size_t leaf_size = 4;

double coordinate(const Vector<double>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

BoundingBox hull_of(const BoundingBox& a, const BoundingBox& b) {
  return box_about(std::array<Vector<double>, 4>{a.low, a.high, b.low, b.high});
}

std::size_t widest_axis(const BoundingBox& box) {
  const Vector<double> width = box.high - box.low;
  if (width.x >= width.y && width.x >= width.z) return 0;
  return width.y >= width.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(const TriangleMesh& mesh) : triangles_(mesh.triangles.size()) {
  std::iota(triangles_.begin(), triangles_.end(), std::size_t{0});
  for (const std::size_t k : triangles_) boxes_.push_back(box_about(mesh.corners(k)));
  if (!triangles_.empty()) build(0, triangles_.size());
  std::vector<BoundingBox> in_order;
  in_order.reserve(boxes_.size());
  for (const std::size_t k : triangles_) in_order.push_back(boxes_[k]);
  boxes_ = std::move(in_order);
}

const BoundingBox& BoxTree::box() const {
  expects(!nodes_.empty(), "a mesh with triangles");
  return nodes_.front().box;
}

// While it builds, boxes_ stands in the order of the mesh.
void BoxTree::build(std::size_t begin, std::size_t end) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  BoundingBox box = boxes_[triangles_[begin]];
  for (std::size_t i = begin; i < end; ++i) box = hull_of(box, boxes_[triangles_[i]]);
  nodes_[at].box = box;
  if (end - begin <= leaf_size) {
    nodes_[at].begin = begin;
    nodes_[at].end = end;
  } else {
    const std::size_t axis = widest_axis(box);
    const auto middle_of = [&](std::size_t k) {
      return coordinate(boxes_[k].low, axis) / 2 + coordinate(boxes_[k].high, axis) / 2;
    };
    const std::size_t half = begin + (end - begin) / 2;
    const auto first = triangles_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(half),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::size_t a, std::size_t b) {
                       const double left = middle_of(a);
                       const double right = middle_of(b);
                       return left != right ? left < right : a < b;
                     });
    build(begin, half);
    build(half, end);
  }
  nodes_[at].next = nodes_.size();
}

}  // namespace radcert
