// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/interpolated_surface.h"

#include <optional>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/surface/interpolated_chart.h"

namespace radcert {

InterpolatedSurface interpolate(const Surface& surface, const Triangulation& triangulation, int degree) {
  using Polynomial = LatticePolynomial<double>;
  expects(Polynomial::smallest_degree <= degree && degree <= Polynomial::largest_degree, "1 <= degree <= 6",
          named("degree", degree));
  InterpolatedSurface result{.surface = surface, .triangulation = {}};
  result.surface.mesh = nullptr;
  result.surface.charts.clear();
  result.surface.diagonals.clear();
  const auto add = [&](Chart chart, Diagonal diagonal) {
    result.surface.charts.push_back(std::move(chart));
    result.surface.diagonals.push_back(diagonal);
    return result.surface.charts.size() - 1;
  };
  std::vector<std::optional<std::size_t>> kept(surface.charts.size());
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    expects(triangle.chart < surface.charts.size(), "a chart of the surface", named("chart", triangle.chart));
    const Chart& chart = surface.charts[triangle.chart];
    if (chart.facts().plane) {
      std::optional<std::size_t>& place = kept[triangle.chart];
      if (!place) place = add(chart, surface.diagonals[triangle.chart]);
      result.triangulation.triangles.push_back({*place, triangle.vertices});
    } else {
      const std::size_t element = result.triangulation.triangles.size();
      const std::size_t place =
          add(interpolated_chart(chart, triangle.vertices, degree,
                                 chart.facts().name + ", element " + std::to_string(element)),
              Diagonal::main);
      result.triangulation.triangles.push_back({place, {{{0, 0}, {1, 0}, {0, 1}}}});
      result.surface.charts_join_smoothly = false;
    }
  }
  return result;
}

}  // namespace radcert
