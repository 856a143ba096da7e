// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "radcert/core/work_limit.h"

namespace radcert::reference {
namespace {

const WorkLimit most_steps("reference/nearest_point: steps", 30, 0,
                           "a point that is not the nearest: no value depends on it");
const WorkLimit most_halvings("reference/nearest_point: halvings of a step", 8, 1,
                              "the search ends: no value depends on it");

}  // namespace

Parameters nearest_on_side(const Parameters& from, const Parameters& to, const Parameters& centre,
                           const Parameters& target, const TangentPlane& plane) {
  const Parameters side = plane.coordinates(to - from);
  const double squared = inner(side, side);
  if (squared == 0) return from;
  const Parameters start = plane.coordinates(from - centre);
  const double l = std::clamp(inner(target - start, side) / squared, 0.0, 1.0);
  return l == 1 ? to : from + l * (to - from);
}

Parameters nearest_in_polygon(const Polygon& polygon, const Parameters& centre, const Parameters& target,
                              const TangentPlane& plane) {
  const Parameters goal = centre + plane.parameters(target);
  bool inside = true;
  for (std::size_t i = 0; i < polygon.count; ++i)
    inside = inside && cross(polygon[i + 1] - polygon[i], goal - polygon[i]) >= 0;
  if (inside) return goal;
  Parameters best = polygon[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters candidate = nearest_on_side(polygon[i], polygon[i + 1], centre, target, plane);
    const double distance = length(plane.coordinates(candidate - centre) - target);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

Parameters nearest_to(const Vector<double>& p, const ChartIn<double>& chart, const Polygon& polygon) {
  Parameters best = (1.0 / static_cast<double>(polygon.count)) * [&] {
    Parameters sum{0, 0};
    for (std::size_t i = 0; i < polygon.count; ++i) sum = sum + polygon[i];
    return sum;
  }();
  Frame<double> frame = chart.frame(best);
  double distance = norm(frame.point - p);
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Frame<double> other = chart.frame(polygon[i]);
    if (norm(other.point - p) >= distance) continue;
    best = polygon[i];
    frame = other;
    distance = norm(other.point - p);
  }
  for (long step = 0; step < most_steps.value(); ++step) {
    const TangentPlane plane(frame.tangent_s, frame.tangent_t);
    const Parameters goal = nearest_in_polygon(polygon, best, plane.projection(p - frame.point), plane);
    Parameters move = goal - best;
    bool nearer = false;
    for (long halving = 0; halving < most_halvings.value() && !nearer; ++halving, move = 0.5 * move) {
      const Parameters candidate = halving == 0 ? goal : best + move;
      const Frame<double> other = chart.frame(candidate);
      const double candidate_distance = norm(other.point - p);
      if (candidate_distance >= distance) continue;
      nearer = true;
      best = candidate;
      frame = other;
      distance = candidate_distance;
    }
    if (!nearer || length(plane.coordinates(move)) < 1e-3 * distance) break;
  }
  return best;
}

double radius_of(const Polygon& polygon, const Parameters& apex, const TangentPlane& plane) {
  double radius = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    radius = std::max(radius, length(plane.coordinates(polygon[i] - apex)));
  return radius;
}

Parameters snapped(const Parameters& apex, const Polygon& polygon, const TangentPlane& plane, double reach) {
  const auto distance = [&](const Parameters& v) { return length(plane.coordinates(v - apex)); };
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (distance(polygon[i]) <= 1.4 * reach) return polygon[i];
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters foot = nearest_on_side(polygon[i], polygon[i + 1], apex, {0, 0}, plane);
    if (distance(foot) <= reach) return foot;
  }
  return apex;
}

}  // namespace radcert::reference
