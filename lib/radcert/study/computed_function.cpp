// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/computed_function.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/study/errors/mean_errors.h"
#include "radcert/study/errors/piece_sums.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

constexpr int sample_degree = 8;

std::vector<Barycentric<double>> error_sample() {
  constexpr double whole = sample_degree;
  std::vector<Barycentric<double>> points;
  for (int i = sample_degree; i >= 0; --i)
    for (int j = sample_degree - i; j >= 0; --j)
      points.push_back({{i / whole, j / whole, (sample_degree - i - j) / whole}});
  return points;
}

/// The largest value over the sample of all elements of what `look` makes of an element, a point of it and
/// u_n there; not a number where that is not one.
template <class Look>
double largest_over_sample(const ComputedFunction& u_n, const Look& look) {
  const std::size_t count = u_n.triangulation.triangles.size();
  const std::vector<Barycentric<double>> points = error_sample();
  const auto largest_of = [&](std::size_t begin, std::size_t end) {
    const auto value = u_n.evaluator();
    double largest = 0;
    for (std::size_t k = begin; k < end; ++k)
      for (const Barycentric<double>& x : points) {
        const double seen = look(k, x, value(k, x));
        if (!(seen <= largest)) largest = seen;  // keeps what is not a number
        if (std::isnan(largest)) return largest;
      }
    return largest;
  };
  const auto larger = [](double a, double b) { return std::isnan(a) || a >= b ? a : b; };
  return u_n.ranks.largest(parallel_reduce_ordered(count, default_grain(count), 0.0, largest_of, larger));
}

std::vector<ElementValue> element_values(const ComputedFunction& u_n) {
  const std::vector<ParameterTriangle>& triangles = u_n.triangulation.triangles;
  std::vector<ElementValue> elements(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    const auto value = u_n.evaluator();
    for (std::size_t k = begin; k < end; ++k) {
      const Chart& chart = u_n.surface.charts[triangles[k].chart];
      elements[k].piece = chart.facts().piece;
      for (std::size_t c = 0; c < 3; ++c) {
        Barycentric<double> corner{{0, 0, 0}};
        corner.x[c] = 1;
        elements[k].corners[c] = chart.in<double>().frame(triangles[k].vertices[c]).point;
        elements[k].corner_values[c] = value(k, corner);
      }
    }
  });
  return elements;
}

std::optional<double> value_at(std::span<const double> values, std::size_t i) {
  return values.empty() ? std::nullopt : std::optional(values[i]);
}

}  // namespace

std::optional<Approximation> uniform_error(const ComputedFunction& u_n, const PiecewiseExpression& solution) {
  const SurfaceFunction u(solution, u_n.surface);
  const double largest =
      largest_over_sample(u_n, [&](std::size_t k, const Barycentric<double>& x, double value) {
        const ParameterTriangle& triangle = u_n.triangulation.triangles[k];
        const ChartIn<double>& chart = u_n.surface.charts[triangle.chart].in<double>();
        return std::abs(u(triangle.chart, chart.frame(triangle.at(x.x)).point) - value);
      });
  if (!std::isfinite(largest)) return std::nullopt;
  return Approximation::without_radius(largest);
}

void require_values(const ComputedFunction& u_n) {
  static_cast<void>(
      largest_over_sample(u_n, [](std::size_t, const Barycentric<double>&, double) { return 0.0; }));
}

std::vector<std::pair<std::string, Approximation>> piece_means(const ComputedFunction& u_n, int order) {
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  const auto sums = piece_sums<2>(u_n, [&](const auto& value, std::size_t k) {
    const ParameterTriangle& triangle = u_n.triangulation.triangles[k];
    const double parallelogram = triangle.doubled_area();
    const ChartIn<double>& chart = u_n.surface.charts[triangle.chart].in<double>();
    std::array<double, 2> found{};
    auto& [area, integral] = found;
    for (std::size_t q = 0; q < rule.weights.size(); ++q) {
      const double weight =
          rule.weights[q] * parallelogram * area_element(chart.frame(triangle.at(rule.points[q].x)));
      area += weight;
      integral += weight * value(k, rule.points[q]);
    }
    return found;
  });
  const std::vector<std::string> names = u_n.surface.piece_names();
  std::vector<std::pair<std::string, Approximation>> means;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& [area, integral] = sums[i];
    means.emplace_back(names[i], Approximation::without_radius(integral / area));
  }
  return means;
}

std::vector<Approximation> with_radius(std::span<const double> values, std::optional<double> radius) {
  std::vector<Approximation> out;
  out.reserve(values.size());
  for (const double value : values)
    out.push_back(radius ? Approximation::estimated(value, *radius) : Approximation::without_radius(value));
  return out;
}

void describe_numbers(const Problem& problem, const ComputedFunction& u_n, int mean_order,
                      LevelResult& result) {
  if (problem.solution) {
    result.uniform_error = uniform_error(u_n, *problem.solution);
    if (const auto errors = mean_errors(u_n, *problem.solution, mean_order, std::nullopt)) {
      result.l2_error = errors->l2;
      result.mean_error = errors->mean;
    }
  }
  result.piece_means = piece_means(u_n, mean_order);
}

void describe_fields(const ComputedFunction& u_n, const NodalValues& values, LevelOutcome& outcome) {
  outcome.elements = element_values(u_n);
  for (std::size_t i = 0; i < values.nodes.size(); ++i)
    outcome.nodes.push_back({.piece = u_n.surface.charts[values.nodes[i].at.chart].facts().piece,
                             .element = i / values.nodes_per_element,
                             .index_in_element = i % values.nodes_per_element,
                             .point = values.nodes[i].point,
                             .normal = values.nodes[i].normal,
                             .u_n = values.u_n[i],
                             .emission = values.emission[i],
                             .u = value_at(values.u, i)});
}

void describe_level(const Problem& problem, const ComputedFunction& u_n, const NodalValues& values,
                    int mean_order, LevelOutcome& outcome) {
  describe_numbers(problem, u_n, mean_order, outcome.result);
  describe_fields(u_n, values, outcome);
}

}  // namespace radcert
