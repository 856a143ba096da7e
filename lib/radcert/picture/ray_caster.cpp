// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A triangle whose corners run counterclockwise as seen from its lit side.
struct LitTriangle {
  std::array<Vector<double>, 3> corners;
  Vector<double> normal;  ///< of length 1, to the lit side
  std::size_t face = 0;
};

/// A ball or disk that is a piece of the surface.
struct RoundBody {
  std::variant<BallBlocker, DiskBlocker> shape;
  std::size_t chart = 0;
  Vector<double> normal;  ///< of a disk, of length 1, to the lit side
  std::size_t face = 0;
};

double determinant(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
  return dot(a, cross(b, c));
}

/// The parts of the way from `eye` by `step` on which a coordinate is within [low, high]; false: none.
bool cut(double eye, double step, double low, double high, double& from, double& to) {
  if (step == 0) return eye >= low && eye <= high;
  const double a = (low - eye) / step;
  const double b = (high - eye) / step;
  // Each is off by two roundings.
  const double margin = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  from = std::max(from, std::min(a, b) - margin);
  to = std::min(to, std::max(a, b) + margin);
  return from <= to;
}

bool may_meet(const BoundingBox& box, const Vector<double>& eye, const Vector<double>& step,
              double farthest) {
  double from = 0;
  double to = farthest;
  return cut(eye.x, step.x, box.low.x, box.high.x, from, to) &&
         cut(eye.y, step.y, box.low.y, box.high.y, from, to) &&
         cut(eye.z, step.z, box.low.z, box.high.z, from, to);
}

/// Whether the ray comes from the lit side of the triangle and its line meets it; exact.
bool meets(const LitTriangle& triangle, const Vector<double>& eye, const Vector<double>& through) {
  const auto& [a, b, c] = triangle.corners;
  if (orientation(a, b, c, eye) <= 0) return false;
  const int ab = orientation(eye, through, a, b);
  if (ab > 0) return false;
  const int bc = orientation(eye, through, b, c);
  if (bc > 0) return false;
  const int ca = orientation(eye, through, c, a);
  // All zero: a line in the triangle's plane, which the eye would be in.
  return ca <= 0;
}

/// The point in which a line that meets the triangle does so, as barycentric weights.
std::optional<std::array<double, 3>> weights(const LitTriangle& triangle, const Vector<double>& eye,
                                             const Vector<double>& step) {
  const Vector<double> a = triangle.corners[0] - eye;
  const Vector<double> b = triangle.corners[1] - eye;
  const Vector<double> c = triangle.corners[2] - eye;
  std::array<double, 3> part{-determinant(step, b, c), -determinant(step, c, a), -determinant(step, a, b)};
  double sum = 0;
  for (double& x : part) sum += x = std::max(x, 0.0);
  if (!(sum > 0) || !std::isfinite(sum)) return std::nullopt;
  // Above the rounding of a point of the triangle, far below a pixel.
  constexpr double inwards = 0x1p-40;
  for (double& x : part) x = (1 - 3 * inwards) * (x / sum) + inwards;
  return part;
}

std::optional<double> distance_to(const BallBlocker& ball, const Vector<double>& eye,
                                  const Vector<double>& step) {
  // |eye + t step - centre|^2 = radius^2, the smaller t: a t^2 - 2 b t + c = 0.
  const Vector<double> to_centre = ball.centre - eye;
  const double a = dot(step, step);
  const double b = dot(step, to_centre);
  // (b^2 - a c) / a = radius^2 - |the part of to_centre across the step|^2.
  const Vector<double> across = to_centre - (b / a) * step;
  const double rest = ball.radius * ball.radius - dot(across, across);
  const double c = dot(to_centre, to_centre) - ball.radius * ball.radius;
  if (!(b > 0) || !(rest >= 0) || !(c > 0)) return std::nullopt;
  return c / (b + std::sqrt(a * rest));
}

std::optional<double> distance_to(const DiskBlocker& disk, const Vector<double>& normal,
                                  const Vector<double>& eye, const Vector<double>& step) {
  const double falling = -dot(normal, step);
  const double height = dot(normal, eye - disk.centre);
  if (!(falling > 0) || !(height > 0)) return std::nullopt;
  const double t = height / falling;
  const Vector<double> from_centre = eye + t * step - disk.centre;
  if (!(dot(from_centre, from_centre) <= disk.radius * disk.radius)) return std::nullopt;
  return t;
}

}  // namespace

struct RayCaster::Parts {
  std::vector<LitTriangle> triangles;  ///< of a mesh, in its order
  BoxTree tree;
  std::vector<RoundBody> bodies;
};

RayCaster::RayCaster(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

Outcome<RayCaster> RayCaster::make(const Surface& surface, std::span<const RoundBlocker> bodies) {
  auto parts = std::make_shared<Parts>();
  std::size_t faces = 0;
  if (surface.mesh) {
    const PlaneClasses planes = plane_classes(*surface.mesh);
    faces = planes.count();
    for (std::size_t k = 0; k < surface.chart_count(); ++k) {
      LitTriangle triangle{.corners = surface.mesh->corners(k), .normal = {}, .face = planes.of_triangle[k]};
      if (surface.charts[k].facts().orientation == Orientation::against_the_cross_product)
        std::swap(triangle.corners[1], triangle.corners[2]);
      triangle.normal = lit_point(surface, {.chart = k, .at = {0.25, 0.25}}).site.normal;
      parts->triangles.push_back(triangle);
    }
    parts->tree = BoxTree(triangle_boxes(*surface.mesh));
  }
  std::vector<std::string> without_body = surface.mesh ? std::vector<std::string>() : surface.piece_names();
  for (const RoundBlocker& blocker : bodies) {
    if (blocker.piece.empty()) continue;
    std::size_t chart = 0;
    while (chart < surface.chart_count() && surface.charts[chart].facts().piece != blocker.piece) ++chart;
    if (chart == surface.chart_count())
      return because("the surface has no piece " + quotation(blocker.piece));
    std::erase(without_body, blocker.piece);
    parts->bodies.push_back({.shape = blocker.shape,
                             .chart = chart,
                             .normal = lit_point(surface, {.chart = chart, .at = {0.25, 0.25}}).site.normal,
                             .face = faces++});
  }
  if (!without_body.empty())
    return because("the piece " + quotation(without_body.front()) +
                   " is neither a mesh nor the skin of a ball or disk: take a mesh of the surface");
  return RayCaster(std::move(parts));
}

std::optional<RayHit> RayCaster::first(const Vector<double>& eye, const Vector<double>& through) const {
  const Vector<double> step = through - eye;
  expects(dot(step, step) > 0, "an eye and another point");
  RayHit best{.at = {}, .distance = infinity, .face = 0};
  const auto take = [&](const Site<double>& site, std::size_t chart, double distance, std::size_t face) {
    if (distance < best.distance)
      best = {.at = {.site = site, .chart = chart}, .distance = distance, .face = face};
  };
  (void)parts_->tree.visit(
      [&](const BoundingBox& box) { return may_meet(box, eye, step, best.distance); },
      [&](std::size_t k) {
        const LitTriangle& triangle = parts_->triangles[k];
        if (!meets(triangle, eye, through)) return true;
        const auto part = weights(triangle, eye, step);
        if (!part) return true;
        const Vector<double> point = (*part)[0] * triangle.corners[0] + (*part)[1] * triangle.corners[1] +
                                     (*part)[2] * triangle.corners[2];
        take({point, triangle.normal}, k, dot(point - eye, step) / dot(step, step), triangle.face);
        return true;
      });
  for (const RoundBody& body : parts_->bodies) {
    if (const auto* ball = std::get_if<BallBlocker>(&body.shape)) {
      if (const auto t = distance_to(*ball, eye, step)) {
        const Vector<double> radius = eye + *t * step - ball->centre;
        const Vector<double> normal = (1 / norm(radius)) * radius;
        take({ball->centre + ball->radius * normal, normal}, body.chart, *t, body.face);
      }
    } else {
      const auto& disk = *std::get_if<DiskBlocker>(&body.shape);
      if (const auto t = distance_to(disk, body.normal, eye, step))
        take({eye + *t * step, body.normal}, body.chart, *t, body.face);
    }
  }
  if (!(best.distance < infinity)) return std::nullopt;
  return best;
}

bool RayCaster::sees(const Vector<double>& eye, const Site<double>& site) const {
  if (!(dot(eye - site.point, site.normal) > 0)) return false;
  const auto hit = first(eye, site.point);
  // What is nearer than the site by more than its own rounding hides it.
  constexpr double own_rounding = 0x1p-30;
  return !hit || hit->distance > 1 - own_rounding;
}

}  // namespace radcert
