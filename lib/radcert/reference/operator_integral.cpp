// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/operator_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/reference/chart_parts.h"
#include "radcert/reference/cubature/adaptive_cubature.h"
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

OperatorPoint operator_point(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
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

/// Adds what P sees of a chart, if that may be less than all of it; false: all of it is seen, and nothing was
/// added.
bool add_if_hidden(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t chart,
                   const SurfaceScene& scene, std::optional<PointView>& view,
                   std::span<const DensityCell> cells) {
  if (!view) view = scene.view(at.p.chart, at.frame.point, at.normal);
  const ChartView seen = scene.seen(*view, chart);
  if (seen.sight == Sight::part) add_visible_parts(cubature, at, chart, seen, cells);
  return seen.sight != Sight::whole;
}

std::optional<SurfaceScene> scene_of(const Surface& surface) {
  return surface.unoccluded ? std::nullopt : std::optional<SurfaceScene>(surface);
}

constexpr std::size_t least_bytes_a_chart = 15000;  // two rules

DensityCell whole_chart(const Surface& surface, std::size_t chart) {
  return {.chart = chart, .polygon = whole_domain(surface.charts[chart].facts().domain)};
}

/// Nothing known but what samples tell.
std::vector<DensityCell> whole_charts(const Surface& surface) {
  std::vector<DensityCell> cells;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    cells.push_back(whole_chart(surface, chart));
  return cells;
}

/// What the deviations of a chart's cells may change of the integral over it, P not in one plane with it but
/// on it.
double deviation_bound(std::span<const DensityCell> cells, const OperatorPoint& at) {
  if (at.surface->charts[at.p.chart].facts().flat_in() && cells.front().chart == at.p.chart) return 0;
  double sum = 0;
  for (const DensityCell& cell : cells)
    if (cell.deviation > 0 || cell.rounding > 0) sum += deviation_at(cell, at.frame.point);
  return sum;
}

/// Whether a curved closed surface is so thin that G over its far side is a peak which only the point nearest
/// to P shows: that point is sought by Newton's method, and Int G = pi tells whether it was found [ac98,
/// section 2].
bool has_to_close(const Surface& surface) {
  constexpr double thin = 1e-2;
  if (!surface.closed || !surface.unoccluded) return false;
  Vector<double> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vector<double> high = -low;
  bool is_curved = false;
  for (const Chart& chart : surface.charts) {
    is_curved = is_curved || !chart.facts().flat_in();
    const Polygon domain = whole_domain(chart.facts().domain);
    for (std::size_t i = 0; i < domain.count; ++i) {
      const Vector<double> q = chart.in<double>().frame(domain[i]).point;
      low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
      high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
    }
  }
  const Vector<double> extent = high - low;
  return is_curved &&
         std::min({extent.x, extent.y, extent.z}) < thin * std::max({extent.x, extent.y, extent.z});
}

double one(const SurfacePoint<double>& /*q*/, const Vector<double>& /*point*/) { return 1; }

}  // namespace

struct AppliedOperator::Prepared {
  const Surface* surface;
  Density u;
  std::vector<FarChart> charts;
  std::optional<SurfaceScene> scene;  ///< where parts of the surface hide others
  std::vector<DensityCell> cells;
  std::vector<std::size_t> first_cell;      ///< of each chart; at the end their number
  std::optional<AppliedOperator> of_one{};  ///< where Int G has to be looked at

  std::span<const DensityCell> cells_of(std::size_t chart) const {
    return std::span(cells).subspan(first_cell[chart], first_cell[chart + 1] - first_cell[chart]);
  }
};

AppliedOperator::AppliedOperator(const Surface& surface, Density u)
    : AppliedOperator(surface, std::move(u), whole_charts(surface), has_to_close(surface)) {}

AppliedOperator::AppliedOperator(const Surface& surface, Density u, std::span<const Expression> formulas)
    : AppliedOperator(surface, std::move(u), density_cells(surface, formulas), has_to_close(surface)) {}

AppliedOperator::AppliedOperator(const Surface& surface, const SurfaceFunction& u)
    : AppliedOperator(
          surface,
          [&u](const PointBlock& q, std::span<double> values) { u.evaluate(q.chart, q.x, q.y, q.z, values); },
          // Of a function without a formula nothing is known between the samples.
          u.is_by_formulas() ? density_cells(surface, u.formulas()) : whole_charts(surface),
          has_to_close(surface)) {}

AppliedOperator::AppliedOperator(const Surface& surface, Density u, std::vector<DensityCell> cells,
                                 bool must_close) {
  expects(static_cast<bool>(u), "a density");
  auto prepared = std::make_shared<Prepared>(
      Prepared{&surface, std::move(u), {}, scene_of(surface), std::move(cells), {}});
  std::size_t place = 0;
  for (std::size_t chart = 0; chart <= surface.chart_count(); ++chart) {
    while (place < prepared->cells.size() && prepared->cells[place].chart < chart) ++place;
    prepared->first_cell.push_back(place);
  }
  constexpr std::size_t bytes = std::size_t{1} << 25U;  // for all charts, but for those that each needs
  const std::size_t bytes_a_chart =
      std::max(bytes / std::max<std::size_t>(surface.chart_count(), 1), least_bytes_a_chart);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    prepared->charts.emplace_back(surface.charts[chart], chart, prepared->u, bytes_a_chart);
  if (must_close) prepared->of_one = AppliedOperator(surface, one, whole_charts(surface), false);
  prepared_ = std::move(prepared);
}

Approximation AppliedOperator::operator()(const SurfacePoint<double>& p) const {
  const Surface& surface = *prepared_->surface;
  const OperatorPoint at = operator_point(surface, p, prepared_->u);
  if (prepared_->of_one) {
    const Approximation whole = (*prepared_->of_one)(p);
    constexpr double slack = 1e-12;
    if (!(std::abs(whole.value - pi<double>()) <= whole.radius + slack))
      throw AccuracyNotReached(
          "Ku at a point of chart " + surface.charts[p.chart].facts().name,
          "the integral of G over the closed surface is not pi within its radius: the surface is too "
          "thin to find its far side");
  }
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
    const std::span<const DensityCell> cells = prepared_->cells_of(chart);
    cubature.add_unseen(deviation_bound(cells, at));
    if (prepared_->scene && !is_own && add_if_hidden(cubature, at, chart, *prepared_->scene, view, cells))
      continue;
    const FarSamples* samples = is_own || cells.size() > 1 ? nullptr : other.samples_for(at.frame.point);
    if (samples != nullptr) {
      cubature.add(other.map(), chart, samples->region(at.frame.point, at.normal, norm(at.frame.point)));
    } else {
      for (const DensityCell& cell : cells) add_part(cubature, at, chart, cell.polygon);
    }
  }
  return cubature.estimate();
}

Approximation operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  const OperatorPoint at = operator_point(surface, p, u);
  const std::optional<SurfaceScene> scene = scene_of(surface);
  std::optional<PointView> view;
  AdaptiveCubature cubature(u);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    if (!scene || chart == p.chart ||
        !add_if_hidden(cubature, at, chart, *scene, view, std::array{whole_chart(surface, chart)}))
      add_part(cubature, at, chart, whole_domain(surface.charts[chart].facts().domain));
  return cubature.estimate();
}

Approximation operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                                const std::array<ParameterPoint<double>, 3>& triangle, const Density& u) {
  const OperatorPoint at = operator_point(surface, p, u);
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
