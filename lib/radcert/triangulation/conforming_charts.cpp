// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/conforming_charts.h"

#include <array>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/hypotheses/conforming.h"

namespace radcert {
namespace {

ParameterPoint<Rational> exact_point(const ParameterPoint<double>& point) {
  return {Rational::exactly(point.s), Rational::exactly(point.t)};
}

PolygonLoop border_of(ChartDomain domain) {
  if (domain == ChartDomain::unit_triangle) return {{0, 0}, {1, 0}, {0, 1}};
  return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

}  // namespace

Outcome<void> conforming(const Surface& surface, const Triangulation& triangulation) {
  std::vector<std::vector<DomainTriangle>> of_chart(surface.chart_count());
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    expects(triangle.chart < surface.chart_count(), "a chart of the surface", named("chart", triangle.chart));
    const auto& v = triangle.vertices;
    of_chart[triangle.chart].push_back({exact_point(v[0]), exact_point(v[1]), exact_point(v[2])});
  }
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
    const std::array<PolygonLoop, 1> loops{border_of(surface.charts[chart].facts().domain)};
    if (const Outcome<void> found = conforming(loops, of_chart[chart]); !found)
      return because("chart " + surface.charts[chart].facts().name + ": " + found.reason());
  }
  return {};
}

}  // namespace radcert
