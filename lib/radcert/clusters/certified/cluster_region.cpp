// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/cluster_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"

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

ComplexBall square_about(const Ball& centre, const Ball& half_width) {
  const Ball zero(0);
  return {widened(centre, half_width), widened(zero, half_width)};
}

double size_of(const Vector<ComplexBall>& v) {
  return std::hypot(v.x.magnitude_bound(), v.y.magnitude_bound(), v.z.magnitude_bound()) * up;
}

Vector<ComplexBall> complex(const Vector<Ball>& v) {
  return {ComplexBall(v.x), ComplexBall(v.y), ComplexBall(v.z)};
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

ClusterRegion::ClusterRegion(const Chart& chart, const ParameterTriangle& triangle)
    : plane_(chart.facts().plane.has_value()) {
  std::array<ParameterPoint<Ball>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = {Ball(triangle.vertices[i].s), Ball(triangle.vertices[i].t)};
  const Ball third = Ball(1) / Ball(3);
  const ParameterPoint<Ball> centroid{third * (v[0].s + v[1].s + v[2].s), third * (v[0].t + v[1].t + v[2].t)};
  const Frame<Ball> frame = chart.in<Ball>().frame(centroid);
  std::array<Vector<Ball>, 3> corners;
  Ball width_s = 0;
  Ball width_t = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterPoint<Ball> d = v[i] - centroid;
    corners[i] = frame.point + d.s * frame.tangent_s + d.t * frame.tangent_t;
    corners_[i] = middle(corners[i]);
    corner_error_ = std::max(corner_error_, largest_distance(corners[i], corners_[i]));
    width_s = max(width_s, abs(d.s));
    width_t = max(width_t, abs(d.t));
  }
  centre_ = centre_of(corners_);
  for (const Vector<Ball>& corner : corners) radius_ = std::max(radius_, largest_distance(corner, centre_));
  unit_normal_ = middle(unit_normal(frame));

  const Ball area = abs(cross(v[1] - v[0], v[2] - v[0])) / Ball(2);
  for (const double g : sizes) {
    if (plane_) {
      neighbourhoods_.push_back({0, 1, (area * norm(frame.area_normal)).upper_double()});
      continue;
    }
    const Ball reach_s = Ball(g) * width_s;
    const Ball reach_t = Ball(g) * width_t;
    const ParameterPoint<ComplexBall> disc =
        g == 1 ? ParameterPoint<ComplexBall>{ComplexBall(widened(centroid.s, width_s)),
                                             ComplexBall(widened(centroid.t, width_t))}
               : ParameterPoint<ComplexBall>{square_about(centroid.s, reach_s),
                                             square_about(centroid.t, reach_t)};
    const Frame<ComplexBall> on = chart.in<ComplexBall>().frame(disc);
    const double turned_s = size_of(on.tangent_s - complex(frame.tangent_s));
    const double turned_t = size_of(on.tangent_t - complex(frame.tangent_t));
    const double length = size_of(on.area_normal);
    const double unit = size_of(unit_normal(on));
    const double rest = (turned_s * reach_s.upper_double() + turned_t * reach_t.upper_double()) / 2 * up;
    if (!std::isfinite(rest) || !std::isfinite(length) || !std::isfinite(unit)) break;
    neighbourhoods_.push_back({rest, unit, length * area.upper_double() * up});
  }
  if (neighbourhoods_.empty()) neighbourhoods_.push_back({infinity, infinity, infinity});
}

double ClusterRegion::least_distance(const Vector<double>& from) const {
  const Vector<double> away = centre_ - from;
  const double distance = norm(away);
  double beyond = infinity;
  for (const Vector<double>& corner : corners_)
    beyond = std::min(beyond, dot(corner - from, away) / distance - corner_error_);
  const double size = distance + real_radius();
  const double by_plane = beyond - neighbourhoods_.front().rest;
  const double by_ball = distance - real_radius();
  return std::max(by_plane, by_ball) - size * 0x1p-40;
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

double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, std::size_t size) {
  const auto& neighbourhoods = seen.neighbourhoods();
  if (size >= neighbourhoods.size()) return infinity;
  const double g = ClusterRegion::sizes[size];
  const double rest = neighbourhoods[size].rest;
  const double linear = g * seen.radius() * up;
  const double distance = from.least_distance(seen.centre());
  const double nearest = (distance - linear) * down;
  if (!(nearest > 0)) return infinity;
  const double farthest = (distance + linear) * up;
  const double least = nearest * nearest * down - (2 * farthest * rest + rest * rest) * up;
  if (!(least > 0)) return infinity;
  const double across = (farthest + rest) * up;
  double product = across * across;
  if (seen.is_plane() && from.is_plane())
    product = std::min(product, g * seen.largest_height(from) * from.largest_height(seen));
  return product / (least * least) * up;
}

}  // namespace radcert
