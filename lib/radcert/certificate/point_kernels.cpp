// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/point_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include "radcert/certificate/face_polynomial.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/core/contract.h"
#include "radcert/geometry/plane.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert::certificate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
/// Of P - Q in length, both displaced.
constexpr double difference_error = 0x1p-44;

double largest_size(const BoundedDouble& x) { return std::abs(x.value()) + x.error(); }

/// From where to where a parameter from 0 to 1 is.
std::pair<double, double> parameters_about(const BoundedDouble& x) {
  const double error = x.error();
  if (error == 0) return {x.value(), x.value()};
  return {std::max(0.0, std::nextafter(x.value() - error, -infinity)),
          std::min(1.0, std::nextafter(x.value() + error, infinity))};
}

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

/// Whether a point lies on a face or its border.
bool lies_on(const Face& face, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& corners = face.corners;
  const Vector<Rational> normal = normal_of(face);
  if (dot(normal, p - corners[0]).sign() != 0) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Rational> side = corners[(i + 1) % corners.size()] - corners[i];
    if (dot(normal, cross(side, p - corners[i])).sign() < 0) return false;
  }
  return true;
}

/// Whether two faces of one plane are turned to one side of it.
bool are_turned_alike(const Face& face, const Face& other) {
  return is_zero(cross(normal_of(face), normal_of(other))) &&
         dot(normal_of(face), normal_of(other)).sign() > 0;
}

/// Whether a point of a face has all of the plane about it in faces that are turned alike and is on no other.
/// Maths     the surface is closed: a side of a face that none of its plane goes on beyond is one of another
///           face too, on which a point of it is. Where another face touches at the point alone T 1 < 1:
///           directions that start behind it bring nothing
bool is_inside(const PolyhedronCertificate& c, const Point& point) {
  const Face& own = c.faces[point.face];
  return lies_on(own, point.at) && std::all_of(c.faces.begin(), c.faces.end(), [&](const Face& face) {
           return !lies_on(face, point.at) || are_turned_alike(own, face);
         });
}

/// Near T w_0 at point k, in the units of densities.
/// Maths     F_0 + c_0 (1 - F 1) + shift, as Shade has it
/// Result    enclosed, and as near as `wanted` where parts that are small enough are seen in part
Ball sent_to(std::size_t k, const PointKernels& kernels, const BallTransport& transport, const Sight& sight,
             const Shades& shades, const Densities& densities, double wanted) {
  constexpr double tolerance = 1e-11;
  const Observers observers = kernels.observers(k);
  View view;
  Shade shade;
  // With smaller parts there are more of them, and at last too many to be looked into.
  for (double mass = 0x1p-14;; mass /= 16) {
    View finer = sight.view(observers.triangle, kernels.box(k), mass);
    Shade of_finer = shades.of(finer.shaded);
    if (!shade.radii.empty() && !(of_finer.radii[0] < shade.radii[0])) break;
    view = std::move(finer);
    shade = std::move(of_finer);
    if (shade.radii[0] <= wanted) break;
  }
  const BallTransport::Values sent = transport(observers, tolerance, std::nullopt, &view);
  if (!std::isfinite(sent.radii[0])) return Ball::failed("a point too near to another face");
  const Ball radius(sent.radii[0]);
  const Ball rest = Ball(1) - widened(Ball(sent.values[densities.constant()]), radius);
  return widened(
      widened(Ball(sent.values[0]), radius) + Ball(shade.constants[0]) * rest + Ball(shade.shifts[0]),
      Ball(shade.radii[0]));
}

}  // namespace

PointKernels::PointKernels(const PolyhedronCertificate& c, const Scene& scene, const Densities& densities,
                           const Sight& sight)
    : scene_(scene), sight_(sight) {
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    const Point& point = c.points[k];
    const Place place = place_in(c.faces[point.face], point.at);
    PlacedPoint placed{.face = point.face,
                       .triangle = scene.triangle(point.face, place.side),
                       .s = bounded(Ball(place.s)),
                       .t = bounded(Ball(place.t)),
                       .box = {},
                       .at = {},
                       .scale = 0};
    std::tie(placed.box.s0, placed.box.s1) = parameters_about(placed.s);
    std::tie(placed.box.t0, placed.box.t1) = parameters_about(placed.t);
    placed.at = scene.triangles()[placed.triangle].point(placed.s.value(), placed.t.value());
    // Lengths are 2^exponent() times those of the scene.
    placed.scale = std::ldexp(std::numbers::inv_pi, -2 * scene.exponent() - densities.exponent(1 + k));
    points_.push_back(placed);
  }
}

Observers PointKernels::observers(std::size_t k) const {
  return {.triangle = points_[k].triangle, .s = {points_[k].s}, .t = {points_[k].t}};
}

std::vector<Seen> PointKernels::seen(const SourcePart& part) const {
  std::vector<Seen> out;
  for (const PlacedPoint& point : points_) out.push_back(sight_.seen(point.triangle, point.box, part));
  return out;
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

PolynomialErrors PointKernels::left(std::size_t triangle, const Box& box, bool in_s,
                                    std::span<const Seen> seen) const {
  PolynomialErrors out{};
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (seen[k] == Seen::none) continue;
    const PolynomialErrors own = polynomial_errors(on_ellipses(k, triangle, box, in_s));
    for (std::size_t n = 0; n < out.size(); ++n) out[n] = std::max(out[n], own[n]);
  }
  return out;
}

double PointKernels::size(std::size_t k, std::size_t triangle, const Box& box) const {
  const PlacedPoint& point = points_[k];
  const SideTriangle& own = scene_.triangles()[triangle];
  if (scene_.coplanar(point.face, own.face)) return 0;
  const double r = Quadrilateral(own, scene_.normal(own.face), box).distance(point.at) - slack;
  if (!(r > 0)) return infinity;
  return point.scale * largest_size(height_over(point, own.face)) / (r * r * r) * upward;
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
    if (!is_inside(c, c.points[k]))
      return Refusal{"/problem/points/" + std::to_string(k),
                     "does not lie inside its face, or between faces of its plane"};
  }
  return std::nullopt;
}

std::vector<Ball> values_of(const PolyhedronCertificate& c, const Sums& sums, const Ball& gap) {
  const Scene scene(c);
  const Densities densities(c);
  const LineBounds lines(c, scene, densities);
  const BallTransport transport(c, scene, densities, lines);
  const Sight sight(c, scene);
  const Shades shades(c, densities);
  const PointKernels kernels(c, scene, densities, sight);
  std::vector<Ball> out;
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    const Ball radius = Ball(sums.radii[k]) + Ball(sums.norms[0]) * Ball(sums.norms[1 + k]) / gap;
    constexpr double share = 0.01;
    const double wanted = share * std::ldexp(radius.to_double(), -densities.exponent());
    const Ball of_w = sent_to(k, kernels, transport, sight, shades, densities, wanted) *
                      power(Ball(2), densities.exponent());
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
