// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/mean_errors.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/chart_pieces.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

struct Sums {
  double area = 0;
  double square = 0;
  double difference = 0;
  double size = 0;  ///< of |u - u_n| and the roundings of u and u_n
};

std::vector<Sums> over_pieces(const ComputedFunction& u_n, const SurfaceFunction& u, int order) {
  const std::vector<ParameterTriangle>& triangles = u_n.triangulation.triangles;
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  std::vector<Sums> by_element(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    const auto value = u_n.evaluator();
    for (std::size_t k = begin; k < end; ++k) {
      const ParameterTriangle& triangle = triangles[k];
      const auto& v = triangle.vertices;
      const double parallelogram = cross(v[1] - v[0], v[2] - v[0]);
      const ChartIn<double>& chart = u_n.surface.charts[triangle.chart].in<double>();
      for (std::size_t q = 0; q < rule.weights.size(); ++q) {
        const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
        const double weight = rule.weights[q] * parallelogram * area_element(frame);
        const double exact = u(triangle.chart, frame.point);
        const double error = exact - value(k, rule.points[q]);
        by_element[k].area += weight;
        by_element[k].square += weight * error * error;
        by_element[k].difference += weight * error;
        by_element[k].size += weight * (std::abs(error) + 16 * std::abs(exact));
      }
    }
  });
  std::vector<Sums> by_piece(u_n.surface.piece_names().size());
  const std::vector<std::size_t> pieces = chart_pieces(u_n.surface);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    Sums& piece = by_piece[pieces[triangles[k].chart]];
    piece.area += by_element[k].area;
    piece.square += by_element[k].square;
    piece.difference += by_element[k].difference;
    piece.size += by_element[k].size;
  }
  return by_piece;
}

}  // namespace

std::optional<MeanErrors> mean_errors(const ComputedFunction& u_n, const PiecewiseExpression& solution,
                                      int order, std::optional<double> l2_radius) {
  const SurfaceFunction u(solution, u_n.surface);
  const std::vector<Sums> fine = over_pieces(u_n, u, order + 1);
  const std::vector<Sums> coarse = l2_radius ? over_pieces(u_n, u, order) : fine;
  const double roundings =
      unit_roundoff<double>() * static_cast<double>(u_n.triangulation.triangles.size() + 256);
  double square = 0;
  double coarse_square = 0;
  Approximation mean = Approximation::estimated(0, 0);
  double mean_radius = 0;
  double size = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    square += fine[k].square;
    coarse_square += coarse[k].square;
    size = std::max(size, fine[k].size / fine[k].area);
    const double now = std::abs(fine[k].difference) / fine[k].area;
    const double before = std::abs(coarse[k].difference) / coarse[k].area;
    mean.value = std::max(mean.value, now);
    mean_radius = std::max(mean_radius, std::abs(now - before) + roundings * fine[k].size / fine[k].area +
                                            l2_radius.value_or(0) / std::sqrt(fine[k].area));
  }
  const double l2 = std::sqrt(square);
  if (!std::isfinite(l2) || !std::isfinite(mean.value)) return std::nullopt;
  if (!l2_radius)
    return MeanErrors{Approximation::without_radius(l2), Approximation::without_radius(mean.value)};
  const double l2_of_rules = std::abs(l2 - std::sqrt(coarse_square)) + roundings * size;
  return MeanErrors{Approximation::estimated(l2, l2_of_rules + *l2_radius),
                    Approximation::estimated(mean.value, mean_radius)};
}

}  // namespace radcert
