// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/operator_integral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/reference/adaptive_cubature.h"
#include "radcert/reference/chart_parts.h"
#include "radcert/reference/far_chart.h"
#include "radcert/reference/polygon.h"
#include "radcert/reference/visible_parts.h"

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
  expects(surface.unoccluded || surface.mesh, "an unoccluded surface or a mesh",
          named("surface", surface.name));
  expects(static_cast<bool>(u), "a density");
  const Frame<double> frame = chart.in<double>().frame(p.at);
  return {&surface, p, frame, unit_normal(frame), &u};
}

/// Adds what P sees of a chart, if that may be less than all of it; false: all of it is seen, and nothing was added.
bool add_if_hidden(AdaptiveCubature& cubature, const Collocation& at, std::size_t chart,
                   const SurfaceScene& scene, std::optional<PointView>& view) {
  if (!view) view = scene.view(at.p.chart, at.frame.point, at.normal);
  const ChartView seen = scene.seen(*view, chart);
  if (seen.sight == Sight::part) add_visible_parts(cubature, at, chart, seen);
  return seen.sight != Sight::whole;
}

std::optional<SurfaceScene> scene_of(const Surface& surface) {
  return surface.unoccluded ? std::nullopt : std::optional<SurfaceScene>(surface);
}

constexpr std::size_t least_bytes_a_chart = 15000;  // two rules

}  // namespace

struct AppliedOperator::Prepared {
  const Surface* surface;
  Density u;
  std::vector<FarChart> charts;
  std::optional<SurfaceScene> scene;  ///< where parts of the surface hide others
};

AppliedOperator::AppliedOperator(const Surface& surface, Density u) {
  expects(static_cast<bool>(u), "a density");
  auto prepared = std::make_shared<Prepared>(Prepared{&surface, std::move(u), {}, scene_of(surface)});
  constexpr std::size_t bytes = std::size_t{1} << 25U;  // for all charts, but for those that each needs
  const std::size_t bytes_a_chart =
      std::max(bytes / std::max<std::size_t>(surface.chart_count(), 1), least_bytes_a_chart);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    prepared->charts.emplace_back(surface.charts[chart], chart, prepared->u, bytes_a_chart);
  prepared_ = std::move(prepared);
}

Estimate AppliedOperator::operator()(const SurfacePoint<double>& p) const {
  const Surface& surface = *prepared_->surface;
  const Collocation at = collocation(surface, p, prepared_->u);
  AdaptiveCubature cubature(prepared_->u, [&at](std::size_t chart) {
    return other_integrand(at, chart, {0, 0});
  });
  std::optional<PointView> view;
  const FarChart& own = prepared_->charts[p.chart];
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
    const FarChart& other = prepared_->charts[chart];
    const bool is_own = chart == p.chart;
    if (!is_own && may_lie_in_one_plane(own, other) &&
        in_one_plane(surface.charts[p.chart], surface.charts[chart]))
      continue;
    if (prepared_->scene && !is_own && add_if_hidden(cubature, at, chart, *prepared_->scene, view)) continue;
    const FarSamples* samples = is_own ? nullptr : other.samples_for(at.frame.point);
    if (samples != nullptr) {
      cubature.add(other.map(), chart, samples->region(at.frame.point, at.normal, norm(at.frame.point)));
    } else {
      add_part(cubature, at, chart, whole_domain(surface.charts[chart].facts().domain));
    }
  }
  return cubature.estimate();
}

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  const std::optional<SurfaceScene> scene = scene_of(surface);
  std::optional<PointView> view;
  AdaptiveCubature cubature(u);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    if (!scene || chart == p.chart || !add_if_hidden(cubature, at, chart, *scene, view))
      add_part(cubature, at, chart, whole_domain(surface.charts[chart].facts().domain));
  return cubature.estimate();
}

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                           const std::array<ParameterPoint<double>, 3>& triangle, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
  expects(chart < surface.chart_count(), "a chart of the surface", named("chart", chart));
  for (const Parameters& corner : triangle)
    expects(in_domain(corner, surface.charts[chart].facts().domain),
            "the triangle in the domain of its chart", named("s", corner.s), named("t", corner.t));
  AdaptiveCubature cubature(u);
  add_part(cubature, at, chart, counterclockwise(triangle));
  return cubature.estimate();
}

}  // namespace radcert::reference
