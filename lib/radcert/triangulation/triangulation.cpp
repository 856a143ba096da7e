// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/triangulation.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/double_double.h"
#include "radcert/triangulation/grading_in_double.h"

namespace radcert {
namespace {

void append_coarse(std::vector<ParameterTriangle>& triangles, const Chart& chart, std::size_t index,
                   Diagonal diagonal) {
  const ParameterPoint<double> p00{0, 0};
  const ParameterPoint<double> p10{1, 0};
  const ParameterPoint<double> p01{0, 1};
  const ParameterPoint<double> p11{1, 1};
  if (chart.facts().domain == ChartDomain::unit_triangle) {
    triangles.push_back({index, {p00, p10, p01}});
  } else if (diagonal == Diagonal::main) {
    triangles.push_back({index, {p00, p10, p11}});
    triangles.push_back({index, {p00, p11, p01}});
  } else {
    triangles.push_back({index, {p00, p10, p01}});
    triangles.push_back({index, {p10, p11, p01}});
  }
}

std::vector<ParameterTriangle> refined(const std::vector<ParameterTriangle>& coarse) {
  std::vector<ParameterTriangle> fine;
  fine.reserve(4 * coarse.size());
  for (const ParameterTriangle& triangle : coarse)
    for (std::size_t c = 0; c < 4; ++c) fine.push_back(child_of(triangle, c));
  return fine;
}

}  // namespace

ParameterTriangle child_of(const ParameterTriangle& triangle, std::size_t c) {
  expects(c < 4, "a child from 0 to 3", named("child", c));
  const auto& [v1, v2, v3] = triangle.vertices;
  const ParameterPoint<double> m12 = 0.5 * (v1 + v2);
  const ParameterPoint<double> m23 = 0.5 * (v2 + v3);
  const ParameterPoint<double> m31 = 0.5 * (v3 + v1);
  switch (c) {
    case 0: return {triangle.chart, {v1, m12, m31}};
    case 1: return {triangle.chart, {m12, v2, m23}};
    case 2: return {triangle.chart, {m31, m23, v3}};
    default: return {triangle.chart, {m23, m31, m12}};
  }
}

double ParameterTriangle::doubled_area() const {
  const auto& [a, b, c] = vertices;
  const DoubleDouble area =
      exact_sum(b.s, -a.s) * exact_sum(c.t, -a.t) - exact_sum(b.t, -a.t) * exact_sum(c.s, -a.s);
  return area.head + area.tail;
}

ParameterTriangle descendant_of(const ParameterTriangle& triangle, int levels, std::size_t number) {
  ParameterTriangle now = triangle;
  for (int l = levels; l-- > 0;) now = child_of(now, (number >> 2 * l) & 3U);
  return now;
}

std::optional<std::uint64_t> triangle_count(const Surface& surface, int level,
                                            const TriangulationOptions& options) {
  expects(level >= 0, "level >= 0", named("level", level));
  std::uint64_t count = options.coarse ? options.coarse->size() : 0;
  if (!options.coarse)
    for (const Chart& chart : surface.charts)
      count += chart.facts().domain == ChartDomain::unit_square ? 2 : 1;
  constexpr std::uint64_t largest = std::uint64_t{1} << 53U;
  for (int k = 0; k < level; ++k) {
    const std::optional<std::uint64_t> finer = checked_multiply(count, 4);
    if (!finer || *finer > largest) return std::nullopt;
    count = *finer;
  }
  return count;
}

Triangulation triangulate(const Surface& surface, int level, const TriangulationOptions& options) {
  expects(triangle_count(surface, level, options).has_value(), "fewer than 2^53 triangles",
          named("level", level));
  expects(options.grading >= 1 && !(options.coarse && options.grading > 1),
          "grading >= 1, and 1 with a coarse triangulation", named("grading", options.grading));
  const std::vector<Diagonal>& diagonals = options.diagonals ? *options.diagonals : surface.diagonals;
  expects(diagonals.size() == surface.charts.size(), "one diagonal a chart",
          named("diagonals", diagonals.size()));
  Triangulation result;
  if (options.coarse) {
    result.triangles = *options.coarse;
    expects(std::is_sorted(
                result.triangles.begin(), result.triangles.end(),
                [](const ParameterTriangle& a, const ParameterTriangle& b) { return a.chart < b.chart; }),
            "a coarse triangulation chart by chart");
    for (int k = 0; k < level; ++k) result.triangles = refined(result.triangles);
    return result;
  }
  for (std::size_t j = 0; j < surface.charts.size(); ++j) {
    std::vector<ParameterTriangle> triangles;
    append_coarse(triangles, surface.charts[j], j, diagonals[j]);
    for (int k = 0; k < level; ++k) triangles = refined(triangles);
    result.triangles.insert(result.triangles.end(), triangles.begin(), triangles.end());
  }
  if (options.grading > 1) {
    for (ParameterTriangle& triangle : result.triangles) {
      if (surface.charts[triangle.chart].facts().domain != ChartDomain::unit_square) continue;
      for (ParameterPoint<double>& v : triangle.vertices)
        v = {graded_coordinate(v.s, options.grading), graded_coordinate(v.t, options.grading)};
    }
  }
  return result;
}

Triangulation triangulate_part(const Surface& surface, int level, const TriangulationOptions& options,
                               const ElementRange& part) {
  const std::optional<std::uint64_t> count = triangle_count(surface, level, options);
  expects(options.grading == 1 && count && part.begin <= part.end && part.end <= *count,
          "triangles of a uniform level", named("begin", part.begin), named("end", part.end));
  const std::vector<ParameterTriangle> coarsest = triangulate(surface, 0, options).triangles;
  Triangulation result;
  result.triangles.reserve(part.end - part.begin);
  for (std::size_t i = part.begin; i < part.end; ++i)
    result.triangles.push_back(
        descendant_of(coarsest[i >> 2 * level], level, i & ((std::size_t{1} << 2 * level) - 1)));
  return result;
}

double mesh_size(const Triangulation& triangulation) {
  expects(!triangulation.triangles.empty(), "a triangulation with triangles");
  double largest = 0;
  for (const ParameterTriangle& triangle : triangulation.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const ParameterPoint<double> side = triangle.vertices[(i + 1) % 3] - triangle.vertices[i];
      largest = std::max(largest, std::hypot(side.s, side.t));
    }
  return largest;
}

}  // namespace radcert
