// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/total_factor.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/reference/operator_integral.h"

namespace radcert::verification::ac98 {

Extremes total_factors(const Surface& surface, std::span<const SurfacePoint<double>> points) {
  const reference::AppliedOperator applied(surface,
                                           [](const reference::PointBlock&, std::span<double> values) {
                                             std::fill(values.begin(), values.end(), 1.0);
                                           });
  std::vector<Approximation> values(points.size());
  parallel_for(points.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Approximation total = applied(points[i]);
      values[i] = {.value = total.value, .radius = total.radius};
    }
  });
  const auto by_value = [](const Approximation& a, const Approximation& b) { return a.value < b.value; };
  const auto by_radius = [](const Approximation& a, const Approximation& b) { return a.radius < b.radius; };
  Extremes extremes{.least = *std::min_element(values.begin(), values.end(), by_value),
                    .largest = *std::max_element(values.begin(), values.end(), by_value)};
  const double radius = std::max_element(values.begin(), values.end(), by_radius)->radius;
  extremes.least.radius = radius;
  extremes.largest.radius = radius;
  return extremes;
}

Approximation least_kernel(const Surface& surface, std::span<const SurfacePoint<double>> points) {
  std::vector<Frame<double>> frames;
  for (const SurfacePoint<double>& p : points)
    frames.push_back(surface.charts[p.chart].in<double>().frame(p.at));
  Approximation least{.value = std::numeric_limits<double>::infinity(), .radius = 0};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const Vector<double> normal_p = unit_normal(frames[i]);
      const Vector<double> normal_q = unit_normal(frames[j]);
      const bool same_chart = points[i].chart == points[j].chart;
      const double g = same_chart ? chord_kernel(surface.charts[points[i].chart].in<double>().chord(
                                                     points[i].at, points[j].at - points[i].at),
                                                 normal_p, normal_q)
                                  : geometric_kernel(frames[i].point, normal_p, frames[j].point, normal_q);
      const double distance = norm(frames[j].point - frames[i].point);
      const double size = norm(frames[i].point) + norm(frames[j].point);
      // Coordinates are rounded to about size/2^53, which moves each of the two products by as much.
      const double radius = 8 * unit_roundoff<double>() * size / (distance * distance * distance);
      if (g < least.value) least.value = g;
      least.radius = std::max(least.radius, same_chart ? 0.0 : radius);
    }
  return least;
}

}  // namespace radcert::verification::ac98
