// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/radcert/light_past_boxes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace radcert::verification::radcert {
namespace {

using Point = ParameterPoint<double>;
using Polygon = std::vector<Point>;  // counterclockwise and convex

/// Coordinates of a point along an axis, and across it.
double along(const Vector<double>& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
Point across(const Vector<double>& p, int axis) {
  return {along(p, (axis + 1) % 3), along(p, (axis + 2) % 3)};
}

double turn(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

Polygon hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.s != b.s ? a.s < b.s : a.t < b.t; });
  Polygon out;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = out.size();
    for (const Point& p : points) {
      while (out.size() >= begin + 2 && turn(out[out.size() - 2], out.back(), p) <= 0) out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

/// What of a polygon lies to the left of a line, or to the right.
Polygon half(const Polygon& polygon, const Point& from, const Point& to, bool left) {
  Polygon out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& p = polygon[k];
    const Point& q = polygon[(k + 1) % polygon.size()];
    const double at_p = left ? turn(from, to, p) : -turn(from, to, p);
    const double at_q = left ? turn(from, to, q) : -turn(from, to, q);
    if (at_p >= 0) out.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) out.push_back(p + (at_p / (at_p - at_q)) * (q - p));
  }
  return out;
}

Polygon shadow(const Vector<double>& point, const AxisBox& box, int axis, double plane) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    const Vector<double> corner{(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
                                (k & 4) != 0 ? box.high.z : box.low.z};
    const Vector<double> ray = corner - point;
    const double scale = (plane - along(point, axis)) / along(ray, axis);
    corners.push_back(across(point + scale * ray, axis));
  }
  return hull(std::move(corners));
}

}  // namespace

double light_past_boxes(const Vector<double>& point, const Vector<double>& normal, const AxisRectangle& lamp,
                        const std::vector<AxisBox>& boxes) {
  const double plane = along(lamp.low, lamp.axis);
  const Point low = across(lamp.low, lamp.axis);
  const Point high = across(lamp.high, lamp.axis);
  std::vector<Polygon> seen{{low, {high.s, low.t}, high, {low.s, high.t}}};
  for (const AxisBox& box : boxes) {
    const Polygon dark = shadow(point, box, lamp.axis, plane);
    std::vector<Polygon> rest;
    for (Polygon polygon : seen)
      for (std::size_t k = 0; k < dark.size() && polygon.size() >= 3; ++k) {
        const Point& from = dark[k];
        const Point& to = dark[(k + 1) % dark.size()];
        if (Polygon outside = half(polygon, from, to, false); outside.size() >= 3)
          rest.push_back(std::move(outside));
        polygon = half(polygon, from, to, true);
      }
    seen = std::move(rest);
  }
  double sum = 0;
  for (const Polygon& polygon : seen)
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto ray = [&](const Point& at) {
        std::array<double, 3> x{};
        x.at(static_cast<std::size_t>(lamp.axis)) = plane;
        x.at(static_cast<std::size_t>((lamp.axis + 1) % 3)) = at.s;
        x.at(static_cast<std::size_t>((lamp.axis + 2) % 3)) = at.t;
        return Vector<double>{x[0], x[1], x[2]} - point;
      };
      const Vector<double> p = ray(polygon[k]);
      const Vector<double> q = ray(polygon[(k + 1) % polygon.size()]);
      const Vector<double> side = cross(p, q);
      const double size = norm(side);
      if (size > 0) sum += std::atan2(size, dot(p, q)) * dot(normal, side) / size;
    }
  return std::abs(sum) / (2 * std::acos(-1.0));
}

}  // namespace radcert::verification::radcert
