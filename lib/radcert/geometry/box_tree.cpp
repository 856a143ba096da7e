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

/// Half of it.
double surface(const BoundingBox& box) {
  const Vector<double> width = box.high - box.low;
  return width.x * width.y + width.y * width.z + width.z * width.x;
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

BoxTree::BoxTree(std::vector<BoundingBox> boxes, TreeParting parting)
    : BoxTree(boxes, middles(boxes), parting == TreeParting::middle ? usual_leaf_size : 1, parting) {}

/// How ranges of order_ are parted in two; leaves() counts what they end in.
struct BoxTree::Division {
  const std::vector<BoundingBox>& boxes;
  std::span<const Vector<double>> points;
  std::size_t leaf_size;
  TreeParting parting;

  [[nodiscard]] std::size_t leaves(std::size_t count) const { return (count + leaf_size - 1) / leaf_size; }

  /// A strict order of the boxes along an axis.
  [[nodiscard]] auto along(std::size_t axis) const {
    return [this, axis](std::size_t a, std::size_t b) {
      const double left = coordinate(points[a], axis);
      const double right = coordinate(points[b], axis);
      return left != right ? left < right : a < b;
    };
  }

  /// Orders the numbers so that two parts stand one behind the other; how many the first one has.
  [[nodiscard]] std::size_t part(std::span<std::size_t> numbers) const {
    return parting == TreeParting::middle ? part_in_the_middle(numbers) : part_by_surface(numbers);
  }

private:
  [[nodiscard]] std::size_t part_in_the_middle(std::span<std::size_t> numbers) const {
    BoundingBox of_points{points[numbers[0]], points[numbers[0]]};
    for (const std::size_t k : numbers)
      of_points = box_about(std::array{of_points.low, of_points.high, points[k]});
    const std::size_t half = leaves(numbers.size()) / 2 * leaf_size;
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half), numbers.end(),
                     along(widest_axis(of_points)));
    return half;
  }

  [[nodiscard]] std::size_t part_by_surface(std::span<std::size_t> numbers) const {
    const std::size_t all = leaves(numbers.size());
    const std::size_t fewest = std::max<std::size_t>(1, all / 8);
    double least = std::numeric_limits<double>::infinity();
    std::size_t first_leaves = all / 2;
    std::vector<std::size_t> best(numbers.begin(), numbers.end());
    std::vector<std::size_t> sorted = best;
    std::vector<double> behind(numbers.size());  // the surface of the box about those from each on
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::sort(sorted.begin(), sorted.end(), along(axis));
      BoundingBox box = boxes[sorted.back()];
      for (std::size_t k = sorted.size(); k-- > 0;) {
        box = hull(box, boxes[sorted[k]]);
        behind[k] = surface(box);
      }
      bool found = false;
      box = boxes[sorted.front()];
      for (std::size_t k = 0, leaf = 1; leaf + fewest <= all; ++leaf) {
        for (; k < leaf * leaf_size; ++k) box = hull(box, boxes[sorted[k]]);
        if (leaf < fewest) continue;
        const double cost =
            static_cast<double>(k) * surface(box) + static_cast<double>(sorted.size() - k) * behind[k];
        if (!(cost < least)) continue;
        least = cost;
        first_leaves = leaf;
        found = true;
      }
      if (found) best = sorted;
    }
    std::copy(best.begin(), best.end(), numbers.begin());
    return first_leaves * leaf_size;
  }
};

BoxTree::BoxTree(std::vector<BoundingBox> boxes, std::span<const Vector<double>> points,
                 std::size_t leaf_size, TreeParting parting)
    : boxes_(std::move(boxes)), order_(boxes_.size()) {
  expects(points.size() == boxes_.size(), "a point for each box", named("points", points.size()),
          named("boxes", boxes_.size()));
  expects(leaf_size >= 1, "leaf_size >= 1");
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!order_.empty()) build({boxes_, points, leaf_size, parting}, 0, order_.size());
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
void BoxTree::build(const Division& division, std::size_t begin, std::size_t end) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  BoundingBox box = boxes_[order_[begin]];
  for (std::size_t i = begin; i < end; ++i) box = hull(box, boxes_[order_[i]]);
  nodes_[at].box = box;
  if (division.leaves(end - begin) == 1) {
    nodes_[at].begin = begin;
    nodes_[at].end = end;
  } else {
    const std::size_t half = begin + division.part(std::span(order_).subspan(begin, end - begin));
    build(division, begin, half);
    build(division, half, end);
  }
  nodes_[at].next = nodes_.size();
}

}  // namespace radcert
