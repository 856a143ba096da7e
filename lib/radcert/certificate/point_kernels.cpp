// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/point_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "radcert/certificate/face_polynomial.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/core/contract.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert::certificate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
/// Of P - Q in length, both displaced.
constexpr double difference_error = 0x1p-44;

double largest_size(const BoundedDouble& x) { return std::abs(x.value()) + x.error(); }

/// Where a point of a face lies in one of its triangles, exactly.
struct Place {
  std::size_t side = 0;
  Rational s;
  Rational t;
};

/// Maths     P = a + s (1-t) along + t inward
Place place_in(const Face& face, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& c = face.corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : c) sum = sum + corner;
  const Vector<Rational> centre = Rational(1, static_cast<long>(c.size())) * sum;
  for (std::size_t side = 0; side < c.size(); ++side) {
    const ParameterPoint<Rational> at =
        coordinates(p - c[side], c[(side + 1) % c.size()] - c[side], centre - c[side]);
    const Rational rest = Rational(1) - at.t;
    if (!(at.s.sign() >= 0 && at.t.sign() >= 0 && at.s <= rest)) continue;
    return {side, rest.sign() == 0 ? Rational(1, 2) : at.s / rest, at.t};
  }
  expects(false, "a point of its face");
  return {};
}

}  // namespace

PointKernels::PointKernels(const PolyhedronCertificate& c, const Scene& scene, const Densities& densities)
    : scene_(scene) {
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    const Point& point = c.points[k];
    const Place place = place_in(c.faces[point.face], point.at);
    PlacedPoint placed{.face = point.face,
                       .triangle = scene.triangle(point.face, place.side),
                       .s = bounded(Ball(place.s)),
                       .t = bounded(Ball(place.t)),
                       .at = {},
                       .scale = 0};
    placed.at = scene.triangles()[placed.triangle].point(placed.s.value(), placed.t.value());
    // Lengths are 2^exponent() times those of the scene.
    placed.scale = std::ldexp(std::numbers::inv_pi, -2 * scene.exponent() - densities.exponent(1 + k));
    points_.push_back(placed);
  }
}

Observers PointKernels::observers(std::size_t k) const {
  return {.triangle = points_[k].triangle, .s = {points_[k].s}, .t = {points_[k].t}};
}

EllipseBounds PointKernels::on_ellipses(std::size_t k, std::size_t triangle, const Box& box,
                                        bool in_s) const {
  EllipseBounds bounds{};
  const PlacedPoint& point = points_[k];
  const SideTriangle& own = scene_.triangles()[triangle];
  if (scene_.coplanar(point.face, own.face)) return bounds;
  const BoxLines lines = box_lines(own, box, in_s);
  const double r = segment_distance(point.at, lines.from, lines.to) - 2 * slack;
  const double height = largest_size(height_over(point, own.face));
  for (std::size_t n = 0; n < bounds.size(); ++n) {
    const double a = ellipse_axes[n] * lines.half * upward;
    const double gap = r - a;
    bounds[n] = a < 0.99 * r ? point.scale * (r + a) * height / (gap * gap * gap * gap) * upward : infinity;
  }
  return bounds;
}

PolynomialErrors PointKernels::left(std::size_t triangle, const Box& box, bool in_s) const {
  PolynomialErrors out{};
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const PolynomialErrors own = polynomial_errors(on_ellipses(k, triangle, box, in_s));
    for (std::size_t n = 0; n < out.size(); ++n) out[n] = std::max(out[n], own[n]);
  }
  return out;
}

double PointKernels::size(std::size_t triangle, const Box& box) const {
  double most = 0;
  const SideTriangle& own = scene_.triangles()[triangle];
  const Quadrilateral part(own, scene_.normal(own.face), box);
  for (const PlacedPoint& point : points_) {
    if (scene_.coplanar(point.face, own.face)) continue;
    const double r = part.distance(point.at) - slack;
    if (!(r > 0)) return infinity;
    most = std::max(most, point.scale * largest_size(height_over(point, own.face)) / (r * r * r) * upward);
  }
  return most;
}

/// Maths     |P-Q|^-4 is off by 4.1 e/r of its size for r >= 2^10 e, and 8 units by its roundings
BoundedDouble PointKernels::at(std::size_t k, std::size_t triangle, const BoundedDouble& s,
                               const BoundedDouble& t) const {
  const PlacedPoint& point = points_[k];
  const SideTriangle& own = scene_.triangles()[triangle];
  if (scene_.coplanar(point.face, own.face)) return BoundedDouble(0);
  const Vector<double> way = own.point(s.value(), t.value()) - point.at;
  const double squared = dot(way, way);
  const double r = std::sqrt(squared);
  if (!(r >= 1024 * difference_error)) return BoundedDouble(0, infinity);
  const BoundedDouble heights = scene_.heights(triangle, point.face).at(s, t) * height_over(point, own.face);
  const double factor = point.scale / (squared * squared);
  const double value = heights.value() * factor;
  const double off =
      heights.error() * factor * 1.01 + std::abs(value) * (4.2 * difference_error / r + 16 * unit);
  return BoundedDouble(value, off * upward);
}

std::optional<Refusal> points_fault(const PolyhedronCertificate& c) {
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    const Point& point = c.points[k];
    const std::vector<Vector<Rational>>& corners = c.faces[point.face].corners;
    const Vector<Rational> normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool inside = dot(normal, point.at - corners[0]).sign() == 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      inside =
          inside &&
          dot(normal, cross(corners[(i + 1) % corners.size()] - corners[i], point.at - corners[i])).sign() >
              0;
    if (!inside) return Refusal{"/problem/points/" + std::to_string(k), "does not lie inside its face"};
  }
  return std::nullopt;
}

std::vector<Ball> values_of(const PolyhedronCertificate& c, const Sums& sums, const Ball& gap) {
  const Scene scene(c);
  const Densities densities(c);
  const LineBounds lines(c, scene, densities);
  const BallTransport transport(c, scene, densities, lines);
  const PointKernels kernels(c, scene, densities);
  std::vector<Ball> out;
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    constexpr double tolerance = 1e-11;
    const BallTransport::Values sent = transport(kernels.observers(k), tolerance, std::nullopt);
    if (!std::isfinite(sent.radii[0])) {
      out.push_back(Ball::failed("a point too near to another face"));
      continue;
    }
    const Ball of_w =
        widened(Ball(sent.values[0]), Ball(sent.radii[0])) * power(Ball(2), densities.exponent());
    const Ball radius = Ball(sums.radii[k]) + Ball(sums.norms[0]) * Ball(sums.norms[1 + k]) / gap;
    const Face& face = c.faces[c.points[k].face];
    const ParameterPoint<Rational> at =
        coordinates(c.points[k].at - face.corners[0], face.corners[1] - face.corners[0],
                    face.corners[2] - face.corners[0]);
    const Rational emission = polynomial_value(face.emission, at.s, at.t);
    const Rational rho = reflectivity_at(face, c.points[k].at);
    // Where rho is 0 nothing has to be known of the rest.
    if (rho.sign() == 0)
      out.emplace_back(emission);
    else
      out.push_back(Ball(emission) + Ball(rho) * widened(of_w + Ball(sums.products[k]), radius));
  }
  return out;
}

}  // namespace radcert::certificate
