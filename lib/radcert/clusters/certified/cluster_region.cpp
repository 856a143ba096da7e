// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/cluster_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"

namespace radcert {
namespace {

/// Far more than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;
constexpr double down = 1 - 0x1p-40;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vector<double> middle(const Vector<Ball>& v) { return {v.x.to_double(), v.y.to_double(), v.z.to_double()}; }

/// At least the distance of all points of a ball from a point.
double largest_distance(const Vector<Ball>& v, const Vector<double>& from) {
  return norm(Vector<Ball>{v.x - Ball(from.x), v.y - Ball(from.y), v.z - Ball(from.z)}).upper_double();
}

/// The centre of the least circle about three points, nearly.
Vector<double> centre_of(const std::array<Vector<double>, 3>& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<double>& a = v[i];
    const Vector<double>& b = v[(i + 1) % 3];
    const Vector<double>& c = v[(i + 2) % 3];
    if (dot(a - c, b - c) <= 0) return 0.5 * (a + b);
  }
  const Vector<double> a = v[1] - v[0];
  const Vector<double> b = v[2] - v[0];
  const Vector<double> n = cross(a, b);
  const Vector<double> rest = cross(dot(a, a) * b - dot(b, b) * a, n);
  return v[0] + (1 / (2 * dot(n, n))) * rest;
}

}  // namespace

ClusterRegion::ClusterRegion(const Chart& chart, const ParameterTriangle& triangle) {
  expects(chart.facts().plane.has_value(), "a plane chart", named("chart", chart.facts().name));
  std::array<ParameterPoint<Ball>, 3> v;
  std::array<Vector<Ball>, 3> corners;
  const ChartIn<Ball>& formula = chart.in<Ball>();
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {Ball(triangle.vertices[i].s), Ball(triangle.vertices[i].t)};
    corners[i] = formula.frame(v[i]).point;
    corners_[i] = middle(corners[i]);
    corner_error_ = std::max(corner_error_, largest_distance(corners[i], corners_[i]));
  }
  centre_ = centre_of(corners_);
  for (const Vector<Ball>& corner : corners) radius_ = std::max(radius_, largest_distance(corner, centre_));
  const Frame<Ball> frame = formula.frame(v[0]);
  unit_normal_ = middle(unit_normal(frame));
  const Ball area = abs(cross(v[1] - v[0], v[2] - v[0])) / Ball(2);
  weight_ = (area * norm(frame.area_normal)).upper_double();
}

double ClusterRegion::least_distance(const Vector<double>& from) const {
  const Vector<double> away = centre_ - from;
  const double distance = norm(away);
  double beyond = infinity;
  for (const Vector<double>& corner : corners_)
    beyond = std::min(beyond, dot(corner - from, away) / distance);
  return std::max(beyond, distance - radius_) - corner_error_ - (distance + radius_) * 0x1p-40;
}

double ClusterRegion::largest_height(const ClusterRegion& above) const {
  double largest = 0;
  double size = 0;
  for (const Vector<double>& corner : corners_) {
    const Vector<double> d = corner - above.corners_[0];
    largest = std::max(largest, std::abs(dot(d, above.unit_normal_)));
    size = std::max(size, norm(d));
  }
  return largest + corner_error_ + above.corner_error_ + size * 0x1p-40;
}

double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, double g) {
  expects(g >= 1, "1 <= g", named("g", g));
  const double nearest = (from.least_distance(seen.centre()) - g * seen.radius() * up) * down;
  if (!(nearest > 0)) return infinity;
  const double heights = g * seen.largest_height(from) * from.largest_height(seen);
  const double squared = nearest * nearest;
  return heights / (squared * squared) * up;
}

}  // namespace radcert
