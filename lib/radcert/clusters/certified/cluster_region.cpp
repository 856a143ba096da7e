// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/cluster_region.h"

#include <algorithm>
#include <cmath>

#include "radcert/clusters/certified/enclosed_nodes.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

/// Far more than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;
constexpr double down = 1 - 0x1p-40;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vector<double> middle(const Vector<Ball>& v) { return {v.x.to_double(), v.y.to_double(), v.z.to_double()}; }
Vector<Ball> exactly(const Vector<double>& v) { return {Ball(v.x), Ball(v.y), Ball(v.z)}; }

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

/// Of x and x', far from where 1 - x is rounding.
constexpr double largest_rate = 1 - 0x1p-16;

/// 2 (1-x)^(-1/2) - 2 for 0 <= x < 1, and the same less x, without cancellation.
double from_first_order(double x) {
  const double s = std::sqrt(1 - x);
  return 2 * x / (s * (1 + s)) * up;
}
double from_second_order(double x) {
  const double s = std::sqrt(1 - x);
  return x * x * (2 + s) / (s * (1 + s) * (1 + s)) * up;
}

}  // namespace

ClusterRegion::ClusterRegion(const Chart& chart, const ParameterTriangle& triangle) {
  expects(chart.is_known_in_balls(), "a chart that is known in balls", named("chart", chart.facts().name));
  const BallPrecision precision(BallPrecision::default_bits);
  if (const std::optional<Vector<Ball>> axes = octant_axes(chart)) {
    be_octant(*axes, triangle);
  } else if (chart.facts().plane) {
    be_plane(chart, triangle);
  } else {
    be_curved(chart, triangle);
  }
}

void ClusterRegion::be_plane(const Chart& chart, const ParameterTriangle& triangle) {
  const std::array<ParameterPoint<Ball>, 3> v = vertices_of(triangle);
  std::array<Vector<Ball>, 3> corners;
  const ChartIn<Ball>& formula = chart.in<Ball>();
  for (std::size_t i = 0; i < 3; ++i) corners[i] = formula.frame(v[i]).point;
  take_corners(corners);
  const Frame<Ball> frame = formula.frame(v[0]);
  take_normal(unit_normal(frame));
  weight_ = (area_of(v) * area_element(frame)).upper_double();
}

void ClusterRegion::be_octant(const Vector<Ball>& axes, const ParameterTriangle& triangle) {
  const std::array<ParameterPoint<Ball>, 3> v = vertices_of(triangle);
  std::array<Vector<Ball>, 3> e;
  std::array<Vector<double>, 3> rounded;
  for (std::size_t i = 0; i < 3; ++i) {
    e[i] = {Ball(1) - v[i].s - v[i].t, v[i].s, v[i].t};
    rounded[i] = middle(e[i]);
  }
  const auto stretched = [&axes](const Vector<Ball>& x) {
    return Vector<Ball>{axes.x * x.x, axes.y * x.y, axes.z * x.z};
  };
  const auto shrunk = [&axes](const Vector<Ball>& x) {
    return Vector<Ball>{x.x / axes.x, x.y / axes.y, x.z / axes.z};
  };
  const Vector<Ball> c = exactly(centre_of(rounded));
  const Ball length = norm(c);
  const Vector<Ball> of_normal = shrunk(c);
  const Ball length_of_normal = norm(of_normal);
  std::array<Vector<Ball>, 3> corners;
  Ball radius = 0;
  Ball radius_of_normal = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Ball> w = e[i] - c;
    radius = max(radius, norm(w));
    radius_of_normal = max(radius_of_normal, norm(shrunk(w)));
    corners[i] = (1 / length) * stretched(c + w - (dot(c, w) / (length * length)) * c);
  }
  take_corners(corners);
  take_normal((Ball(-1) / length_of_normal) * of_normal);
  rate_ = (radius / length).upper_double();
  normal_rate_ = (radius_of_normal / length_of_normal).upper_double();
  size_ = max(abs(axes.x), max(abs(axes.y), abs(axes.z))).upper_double();
  weight_ = (area_of(v) * abs(axes.x * axes.y * axes.z) * length_of_normal / power(length, 4)).upper_double();
}

void ClusterRegion::be_curved(const Chart& chart, const ParameterTriangle& triangle) {
  growth_.emplace(chart, triangle);
  const ParameterPoint<Ball> middle{Ball(growth_->middle().s), Ball(growth_->middle().t)};
  const Frame<Ball> frame = chart.in<Ball>().frame(middle);
  const std::array<ParameterPoint<Ball>, 3> v = vertices_of(triangle);
  std::array<Vector<Ball>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterPoint<Ball> w = v[i] - middle;
    corners[i] = frame.point + w.s * frame.tangent_s + w.t * frame.tangent_t;
  }
  take_corners(corners);
  take_normal(unit_normal(frame));
  weight_ = area_of(v).upper_double();
}

void ClusterRegion::take_corners(const std::array<Vector<Ball>, 3>& corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    corners_[i] = middle(corners[i]);
    corner_error_ = std::max(corner_error_, norm(corners[i] - exactly(corners_[i])).upper_double());
  }
  centre_ = centre_of(corners_);
  for (const Vector<double>& corner : corners_)
    radius_ = std::max(radius_, norm(exactly(corner) - exactly(centre_)).upper_double());
}

void ClusterRegion::take_normal(const Vector<Ball>& normal) {
  normal_ = middle(normal);
  normal_error_ = norm(normal - exactly(normal_)).upper_double();
}

double ClusterRegion::limit() const {
  if (growth_) return growth_->limit();
  const double fastest = std::max(rate_, normal_rate_);
  return fastest > 0 ? largest_rate / fastest : infinity;
}

ClusterRegion::Neighbourhood ClusterRegion::at(double g) const {
  if (growth_) {
    const ChartGrowth::Bounds grown = growth_->at(g);
    return {.g = g,
            .bend = (g * corner_error_ + grown.bend) * up,
            .turn = (normal_error_ + grown.turn) * up,
            .weight = weight_ * grown.area * up};
  }
  const double x = rate_ * g * up;
  const double of_normal = normal_rate_ * g * up;
  if (!(x < largest_rate && of_normal < largest_rate))
    return {.g = g, .bend = infinity, .turn = infinity, .weight = infinity};
  // Lie's norm of an error is at most g times that of the corners.
  return {.g = g,
          .bend = (g * corner_error_ + size_ * from_second_order(x)) * up,
          .turn = (normal_error_ + from_first_order(of_normal)) * up,
          .weight = weight_ * (1 + of_normal) / std::pow((1 - x) * down, 4) * up};
}

double ClusterRegion::least_distance(const Vector<double>& from) const {
  const Vector<double> away = centre_ - from;
  const double distance = norm(away);
  if (!(distance > 0)) return 0;
  double beyond = infinity;
  for (const Vector<double>& corner : corners_)
    beyond = std::min(beyond, dot(corner - from, away) / distance);
  return std::max(beyond, distance - radius_) - at(1).bend - (distance + radius_) * 0x1p-40;
}

double ClusterRegion::largest_height(const ClusterRegion& above) const {
  double largest = 0;
  double size = 0;
  for (const Vector<double>& corner : corners_) {
    const Vector<double> d = corner - above.centre_;
    largest = std::max(largest, std::abs(dot(d, above.normal_)));
    size = std::max(size, norm(d));
  }
  return largest + size * 0x1p-40;
}

KernelFactors kernel_factors(const ClusterRegion& seen, const ClusterRegion& from, double g) {
  expects(g >= 1, "1 <= g", named("g", g));
  const ClusterRegion::Neighbourhood complex = seen.at(g);
  const ClusterRegion::Neighbourhood real = from.at(1);
  const double moved = (g * seen.radius() + complex.bend) * up;
  const double farthest = (norm(seen.centre() - from.centre()) + moved + from.radius() + real.bend) * up;
  const double bends = (complex.bend + real.bend) * up;
  return {
      .nearest = (from.least_distance(seen.centre()) - moved) * down,
      .over_p =
          (g * seen.largest_height(from) + from.largest_height(from) + bends + farthest * real.turn) * up,
      .over_q =
          (from.largest_height(seen) + g * seen.largest_height(seen) + bends + farthest * complex.turn) * up};
}

double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, double g) {
  const KernelFactors f = kernel_factors(seen, from, g);
  if (!(f.nearest > 0) || !std::isfinite(f.over_p * f.over_q)) return infinity;
  const double squared = f.nearest * f.nearest;
  const double fourth = squared * squared;
  const double factors = f.over_p * f.over_q;
  const double bound = factors / fourth * up;
  // Beyond the normal numbers roundings are not of relative size.
  const bool normal = std::isnormal(fourth) && std::isnormal(factors) && std::isnormal(bound);
  return normal ? bound : infinity;
}

}  // namespace radcert
