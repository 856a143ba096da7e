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

VertexTree::VertexTree(std::span<const Vector<double>> points, std::vector<std::size_t> numbers)
    : numbers_(std::move(numbers)) {
  expects(!numbers_.empty(), "at least one vertex");
  std::vector<BoundingBox> boxes;
  for (const std::size_t k : numbers_) {
    points_.push_back(points[k]);
    boxes.push_back({points[k], points[k]});
  }
  tree_ = BoxTree(std::move(boxes), points_, leaf_size);
}

std::optional<std::size_t> VertexTree::farthest_beyond(const Vector<double>& a, const Vector<double>& b,
                                                       const Vector<double>& c) const {
  const PlaneFunction plane(a, b, c);
  std::optional<std::size_t> farthest;
  double best = 0;
  tree_.search(
      best, [&](const BoundingBox& box) { return plane.upper(box.low, box.high); },
      [&](std::size_t k) {
        const auto range = plane.at(points_[k]);
        if ((farthest ? range.value > best : range.value + range.error > 0) &&
            plane.beyond(points_[k], range)) {
          farthest = numbers_[k];
          best = std::max(best, range.value);
        }
        return best;
      });
  return farthest;
}

}  // namespace radcert
