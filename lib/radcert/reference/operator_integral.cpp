// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/operator_integral.h"

#include "radcert/core/contract.h"
#include "radcert/reference/adaptive_cubature.h"
#include "radcert/reference/chart_parts.h"
#include "radcert/reference/polygon.h"

namespace radcert::reference {
namespace {

bool in_domain(const Parameters& x, ChartDomain domain) {
  constexpr double slack = 1e-13;  // corners of triangles are rounded
  if (!(x.s >= -slack && x.t >= -slack)) return false;
  return domain == ChartDomain::unit_triangle ? x.s + x.t <= 1 + slack : x.s <= 1 + slack && x.t <= 1 + slack;
}

Collocation collocation(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  expects(p.chart < surface.chart_count(), "a chart of the surface", named("chart", p.chart));
  const Chart& chart = surface.charts[p.chart];
  expects(in_domain(p.at, chart.facts().domain), "P in the domain of its chart", named("s", p.at.s),
          named("t", p.at.t));
  expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
  expects(static_cast<bool>(u), "a density");
  const Frame<double> frame = chart.in<double>().frame(p.at);
  return {&surface, p, frame, unit_normal(frame), &u};
}

}  // namespace

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  AdaptiveCubature cubature;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    add_part(cubature, at, chart, whole_domain(surface.charts[chart].facts().domain));
  return cubature.estimate();
}

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                           const std::array<ParameterPoint<double>, 3>& triangle, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  expects(chart < surface.chart_count(), "a chart of the surface", named("chart", chart));
  for (const Parameters& corner : triangle)
    expects(in_domain(corner, surface.charts[chart].facts().domain),
            "the triangle in the domain of its chart", named("s", corner.s), named("t", corner.t));
  AdaptiveCubature cubature;
  add_part(cubature, at, chart, counterclockwise(triangle));
  return cubature.estimate();
}

}  // namespace radcert::reference
