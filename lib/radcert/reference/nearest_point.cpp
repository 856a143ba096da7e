// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/nearest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"

namespace radcert::reference {
namespace {

const WorkLimit most_steps(
    "reference/nearest_point: steps", 30, 0,
    "AccuracyNotReached, unless the next step is small or no point can be much nearer");
const WorkLimit most_halvings("reference/nearest_point: halvings of a step", 8, 1,
                              "AccuracyNotReached, unless the step is small or no point can be much nearer");

/// Whether no point of the polygon is nearer to P than a fourth of a distance, by a grid over each triangle
/// of a fan: what lies between its points is at most a side of its cells away from one.
bool is_as_near_as_any(double distance, const Vector<double>& p, const ChartIn<double>& chart,
                       const Polygon& polygon) {
  constexpr std::size_t cells = 16;
  using Row = std::array<Vector<double>, cells + 1>;
  double least = distance;
  double longest = 0;
  for (std::size_t k = 1; k + 1 < polygon.count; ++k) {
    Row before{};
    for (std::size_t i = 0; i <= cells; ++i) {
      const double a = static_cast<double>(i) / cells;
      Row row{};
      for (std::size_t j = 0; j <= cells; ++j) {
        const double b = static_cast<double>(j) / cells;
        row[j] =
            chart.frame(polygon[0] + a * (polygon[k] - polygon[0]) + (a * b) * (polygon[k + 1] - polygon[k]))
                .point;
        least = std::min(least, norm(row[j] - p));
        if (j > 0) longest = std::max(longest, norm(row[j] - row[j - 1]));
        if (i > 0) longest = std::max(longest, norm(row[j] - before[j]));
      }
      before = row;
    }
  }
  return least - longest >= distance / 4;
}

[[noreturn]] void not_found(long steps) {
  throw AccuracyNotReached("the integral operator", "the point of a chart nearest to P was not found by " +
                                                        std::to_string(steps) + " steps");
}

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
  for (long step = 0;; ++step) {
    const TangentPlane plane(frame.tangent_s, frame.tangent_t);
    const Parameters goal = nearest_in_polygon(polygon, best, plane.projection(p - frame.point), plane);
    Parameters move = goal - best;
    // Below this a step that does not come nearer is lost in the rounding of points.
    const double hidden = 1e-7 * (plane.ss + std::hypot(plane.st, plane.tt) + norm(frame.point) + norm(p));
    const bool large = length(plane.coordinates(move)) > std::max(1e-3 * distance, hidden);
    if (step == most_steps.value()) {
      if (large && !is_as_near_as_any(distance, p, chart, polygon)) not_found(step);
      break;
    }
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
    if (!nearer && large && !is_as_near_as_any(distance, p, chart, polygon)) not_found(step);
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
