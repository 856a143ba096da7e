// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/mean_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/study/errors/piece_sums.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

/// Area, Int (u - u_n)^2, Int u - u_n, and of |u - u_n| and the roundings of u and u_n.
using Sums = std::array<double, 4>;

std::vector<Sums> over_pieces(const ComputedFunction& u_n, const SurfaceFunction& u, int order) {
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  return piece_sums<4>(u_n, [&](const auto& value, std::size_t k) {
    const ParameterTriangle& triangle = u_n.triangulation.triangles[k];
    const double parallelogram = triangle.doubled_area();
    const ChartIn<double>& chart = u_n.surface.charts[triangle.chart].in<double>();
    Sums sums{};
    auto& [area, square, difference, size] = sums;
    for (std::size_t q = 0; q < rule.weights.size(); ++q) {
      const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
      const double weight = rule.weights[q] * parallelogram * area_element(frame);
      const double exact = u(triangle.chart, frame.point);
      const double error = exact - value(k, rule.points[q]);
      area += weight;
      square += weight * error * error;
      difference += weight * error;
      size += weight * (std::abs(error) + 16 * std::abs(exact));
    }
    return sums;
  });
}

}  // namespace

std::optional<MeanErrors> mean_errors(const ComputedFunction& u_n, const PiecewiseExpression& solution,
                                      int order, std::optional<double> l2_radius) {
  const SurfaceFunction u(solution, u_n.surface);
  const std::vector<Sums> fine = over_pieces(u_n, u, order + 1);
  const std::vector<Sums> coarse = l2_radius ? over_pieces(u_n, u, order) : fine;
  const double roundings = unit_roundoff<double>() * static_cast<double>(all_elements(u_n) + 256);
  double square = 0;
  double coarse_square = 0;
  Approximation mean = Approximation::estimated(0, 0);
  double mean_radius = 0;
  double size = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const auto& [area, square_here, difference, size_here] = fine[k];
    const auto& [coarse_area, coarse_square_here, coarse_difference, coarse_size] = coarse[k];
    square += square_here;
    coarse_square += coarse_square_here;
    size = std::max(size, size_here / area);
    const double now = std::abs(difference) / area;
    const double before = std::abs(coarse_difference) / coarse_area;
    mean.value = std::max(mean.value, now);
    mean_radius = std::max(mean_radius, std::abs(now - before) + roundings * size_here / area +
                                            l2_radius.value_or(0) / std::sqrt(area));
  }
  const double l2 = std::sqrt(square);
  if (!std::isfinite(l2) || !std::isfinite(mean.value)) return std::nullopt;
  if (!l2_radius)
    return MeanErrors{Approximation::without_radius(l2), Approximation::without_radius(mean.value)};
  // Of a sum of n squares what underflows is below n 2^-1074; where u = u_n = 0 nothing does.
  const double of_underflow =
      size > 0 ? std::sqrt(static_cast<double>(all_elements(u_n))) * (order + 1) * 0x1p-537 : 0;
  const double l2_of_rules = std::abs(l2 - std::sqrt(coarse_square)) + roundings * size + of_underflow;
  return MeanErrors{Approximation::estimated(l2, l2_of_rules + *l2_radius),
                    Approximation::estimated(mean.value, mean_radius)};
}

}  // namespace radcert
