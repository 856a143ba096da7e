// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/vertex_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr std::size_t leaf_size = 8;

// What underflow may take from a product of two differences is below 2^-1074, and coordinates are below 1e61.
constexpr double underflow = 1e-250;

double coordinate(const Vector<double>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The distance beyond a plane, times the length of its normal, with a bound of what rounding does to it.
class PlaneFunction {
public:
  PlaneFunction(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c)
      : a_(a), b_(b), c_(c), normal_(cross(b - a, c - a)) {
    const Vector<double> e = absolute(b - a);
    const Vector<double> f = absolute(c - a);
    // A component of the normal is a sum of two products of differences: four roundings at most. The product
    // with v - a and the sum of three add four; the factor 2 covers the roundings of the bound itself.
    constexpr double unit = 16 * unit_roundoff<double>();
    slack_ = unit * Vector<double>{e.y * f.z + e.z * f.y, e.z * f.x + e.x * f.z, e.x * f.y + e.y * f.x};
  }

  struct Range {
    double value;
    double error;
  };
  [[nodiscard]] Range at(const Vector<double>& v) const {
    const Vector<double> d = v - a_;
    return {dot(normal_, d), dot(slack_, absolute(d)) + underflow};
  }
  /// An upper bound over a box.
  [[nodiscard]] double upper(const Vector<double>& low, const Vector<double>& high) const {
    const Vector<double> d = low - a_;
    const Vector<double> e = high - a_;
    return std::max(normal_.x * d.x, normal_.x * e.x) + std::max(normal_.y * d.y, normal_.y * e.y) +
           std::max(normal_.z * d.z, normal_.z * e.z) + slack_.x * std::max(std::abs(d.x), std::abs(e.x)) +
           slack_.y * std::max(std::abs(d.y), std::abs(e.y)) +
           slack_.z * std::max(std::abs(d.z), std::abs(e.z)) + underflow;
  }
  [[nodiscard]] bool beyond(const Vector<double>& v, const Range& range) const {
    if (range.value > range.error) return true;
    if (range.value < -range.error) return false;
    return orientation(a_, b_, c_, v) > 0;
  }

private:
  static Vector<double> absolute(const Vector<double>& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  }
  Vector<double> a_;
  Vector<double> b_;
  Vector<double> c_;
  Vector<double> normal_;
  Vector<double> slack_;
};

}  // namespace

VertexTree::VertexTree(const std::vector<Vector<double>>& points, std::vector<std::size_t> numbers)
    : numbers_(std::move(numbers)) {
  expects(!numbers_.empty(), "at least one vertex");
  points_ = points;
  build(0, numbers_.size());
}

std::size_t VertexTree::build(std::size_t begin, std::size_t end) {
  const std::size_t here = nodes_.size();
  nodes_.emplace_back();
  Node node{.low = points_[numbers_[begin]], .high = points_[numbers_[begin]], .begin = begin, .end = end};
  for (std::size_t i = begin; i < end; ++i) {
    const Vector<double>& v = points_[numbers_[i]];
    node.low = {std::min(node.low.x, v.x), std::min(node.low.y, v.y), std::min(node.low.z, v.z)};
    node.high = {std::max(node.high.x, v.x), std::max(node.high.y, v.y), std::max(node.high.z, v.z)};
  }
  if (end - begin > leaf_size) {
    const Vector<double> size = node.high - node.low;
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto first = numbers_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::size_t i, std::size_t j) {
                       return coordinate(points_[i], axis) < coordinate(points_[j], axis);
                     });
    node.child[0] = build(begin, middle);
    node.child[1] = build(middle, end);
  }
  nodes_[here] = node;
  return here;
}

std::optional<std::size_t> VertexTree::farthest_beyond(const Vector<double>& a, const Vector<double>& b,
                                                       const Vector<double>& c) const {
  const PlaneFunction plane(a, b, c);
  std::optional<std::size_t> farthest;
  double best = 0;
  struct Pending {
    std::size_t node;
    double upper;
  };
  std::vector<Pending> pending{{0, plane.upper(nodes_[0].low, nodes_[0].high)}};
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    if (next.upper <= best) continue;
    const Node& node = nodes_[next.node];
    if (node.child[0] != 0) {
      std::array<Pending, 2> halves;
      for (std::size_t i = 0; i < 2; ++i)
        halves[i] = {node.child[i], plane.upper(nodes_[node.child[i]].low, nodes_[node.child[i]].high)};
      if (halves[0].upper > halves[1].upper) std::swap(halves[0], halves[1]);
      pending.insert(pending.end(), halves.begin(), halves.end());
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const Vector<double>& v = points_[numbers_[i]];
      const auto range = plane.at(v);
      if (farthest ? range.value > best : range.value + range.error > 0) {
        if (!plane.beyond(v, range)) continue;
        farthest = numbers_[i];
        best = std::max(best, range.value);
      }
    }
  }
  return farthest;
}

}  // namespace radcert
