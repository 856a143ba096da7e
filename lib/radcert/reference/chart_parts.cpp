// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/chart_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/reference/cubature/kernel_integrands.h"
#include "radcert/reference/decomposition.h"
#include "radcert/reference/nearest_point.h"
#include "radcert/reference/tangent_plane.h"

namespace radcert::reference {
namespace {

using Point = Vector<double>;

constexpr double far_away = 0.9;  // in radii of a part: farther off a plain product rule is cheaper

/// What a graded part is taken for, beside what its maps say.
constexpr Roughness graded_roughness{.across = 2.4, .along = 1.5, .analytic = false};

/// How much a chart turns over a polygon, as a roughness: by the normals at the corners.
double bend_of(const ChartIn<double>& chart, const Polygon& polygon) {
  double bend = 0;
  const Point first = unit_normal(chart.frame(polygon[0]));
  for (std::size_t i = 1; i < polygon.count; ++i)
    bend = std::max(bend, norm(unit_normal(chart.frame(polygon[i])) - first));
  return bend;
}

/// Of G over a polygon at the distance delta, its peak at worst above the middle.
Roughness far_roughness(const Polygon& polygon, const TangentPlane& plane, double delta, double bend) {
  double s_extent = 0;
  double t_extent = 0;
  for (std::size_t i = 1; i < polygon.count; ++i) {
    s_extent = std::max(s_extent, std::abs(polygon[i].s - polygon[0].s));
    t_extent = std::max(t_extent, std::abs(polygon[i].t - polygon[0].t));
  }
  return {.across = std::hypot(s_extent * plane.ss / delta, bend),
          .along = std::hypot(t_extent * std::hypot(plane.st, plane.tt) / delta, bend)};
}

/// The sum of a_i b_i as if in twice the precision [Ogita, Rump, Oishi 2005, Dot2].
template <std::size_t n>
double accurate_dot(const std::array<double, n>& a, const std::array<double, n>& b) {
  double sum = 0;
  double error = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double product = a[i] * b[i];
    const double product_error = std::fma(a[i], b[i], -product);
    const double next = sum + product;
    const double part = next - sum;
    error += ((sum - (next - part)) + (product - part)) + product_error;
    sum = next;
  }
  return sum + error;
}

/// F(q) - F(p) for two affine charts, each coordinate correctly rounded but for a cancellation of 16 digits
/// and more.
Point accurate_difference(const Frame<double>& f_q, const Parameters& q, const Frame<double>& f_p,
                          const Parameters& p) {
  const std::array<double, 6> factor{1, q.s, q.t, -1, -p.s, -p.t};
  const auto coordinate = [&](double Point::*x) {
    return accurate_dot<6>(
        {f_q.point.*x, f_q.tangent_s.*x, f_q.tangent_t.*x, f_p.point.*x, f_p.tangent_s.*x, f_p.tangent_t.*x},
        factor);
  };
  return {coordinate(&Point::x), coordinate(&Point::y), coordinate(&Point::z)};
}

/// About the largest |G u| near P on a smooth piece, with a margin: sampled in eight directions.
double bound_near(const OperatorPoint& at) {
  const ChartIn<double>& chart = at.surface->charts[at.p.chart].in<double>();
  constexpr double step = 1e-4;
  double greatest = 0;
  for (const int s : {-1, 0, 1})
    for (const int t : {-1, 0, 1}) {
      if (s == 0 && t == 0) continue;
      const Parameters w{step * s, step * t};
      const double g =
          chord_kernel(chart.chord(at.p.at, w), at.normal, unit_normal(chart.frame(at.p.at + w)));
      if (std::isfinite(g)) greatest = std::max(greatest, std::abs(g));
    }
  return 4 * greatest * std::abs((*at.density)(at.p, at.frame.point));
}

void add_own_chart(AdaptiveCubature& cubature, const OperatorPoint& at, const Polygon& polygon) {
  const Chart& chart = at.surface->charts[at.p.chart];
  const Parameters p = at.p.at;
  const TangentPlane plane(at.frame.tangent_s, at.frame.tangent_t);
  const auto integrand = [&](const Parameters& apex) {
    return cubature.add(ChordIntegrand{.target = {at.p.chart, apex},
                                       .chart = &chart.in<Pack>(),
                                       .p = p,
                                       .offset = apex - p,
                                       .normal_p = at.normal});
  };
  Polygon analytic = polygon;
  double scale = std::numeric_limits<double>::infinity();  // of the structure that a singular line makes
  const bool singular = chart.facts().singular == SingularLine::s_zero;
  if (singular) {
    const Spread spread{.centre = p.t, .delta = std::max(0.5 * p.s * plane.ss / plane.tt, 1e-3 * (p.s == 0))};
    if (p.s == 0) {
      const Parameters nearest = nearest_in_polygon(polygon, p, {0, 0}, plane);
      if (nearest == p) {
        add_sectors(cubature, integrand(p), polygon, p, plane, {.graded = true, .analytic = false});
      } else {
        add_slabs(cubature, integrand(p), polygon, p, true,
                  {.centre = p.t, .delta = length(plane.coordinates(nearest - p)) / plane.tt},
                  graded_roughness);
      }
      return;
    }
    const Polygon strip = clipped(polygon, {1, 0}, 0.5 * p.s, -1);
    if (strip.count != 0) add_slabs(cubature, integrand(p), strip, p, true, spread, graded_roughness);
    analytic = clipped(polygon, {1, 0}, 0.5 * p.s, 1);
    if (analytic.count == 0) return;
    scale = 0.5 * p.s * plane.ss;
  }
  const double bend = bend_of(chart.in<double>(), analytic);
  Parameters apex = nearest_in_polygon(analytic, p, {0, 0}, plane);
  double distance = length(plane.coordinates(apex - p));
  if (distance < 4 * roundoff * (plane.ss + plane.tt)) distance = 0;
  if (distance > 0) apex = snapped(apex, analytic, plane, 0.25 * distance);
  if (distance > far_away * radius_of(analytic, apex, plane)) {
    if (singular) {
      add_slabs(cubature, integrand(p), analytic, p, true, {}, graded_roughness);
    } else {
      add_triangles(cubature, integrand(analytic[0]), analytic,
                    far_roughness(analytic, plane, distance, bend));
    }
    return;
  }
  const double delta = distance > 0 ? std::min(distance, scale) : std::isfinite(scale) ? scale : 0;
  add_sectors(cubature, integrand(apex), analytic, apex, plane,
              {.delta = delta, .margin = singular ? scale : 0, .bend = bend, .analytic = !singular});
}

/// F_index(q) - P.
Point difference(const OperatorPoint& at, std::size_t index, const Parameters& q) {
  const Chart& own = at.surface->charts[at.p.chart];
  const Chart& chart = at.surface->charts[index];
  if (!own.facts().plane || !chart.facts().plane) return chart.in<double>().frame(q).point - at.frame.point;
  return accurate_difference(chart.in<double>().frame({0, 0}), q, own.in<double>().frame({0, 0}), at.p.at);
}

/// Whether the surface goes on smoothly from P to the disk of a chart about the point nearest to P: n_Q is
/// about n_P all over it. The far sheet of a flat body is no such disk, nor is one about a rim that bends
/// within it.
bool goes_on_smoothly(const OperatorPoint& at, const ChartIn<double>& chart, ChartDomain domain,
                      const Parameters& nearest, double radius) {
  constexpr double least_cosine = 0.9;
  const Frame<double> frame = chart.frame(nearest);
  const Parameters step{radius / norm(frame.tangent_s), radius / norm(frame.tangent_t)};
  for (const int s : {-1, 0, 1})
    for (const int t : {-1, 0, 1}) {
      Parameters q{std::clamp(nearest.s + s * step.s, 0.0, 1.0),
                   std::clamp(nearest.t + t * step.t, 0.0, 1.0)};
      if (domain == ChartDomain::unit_triangle) q.t = std::min(q.t, 1 - q.s);
      if (!(dot(unit_normal(chart.frame(q)), at.normal) > least_cosine)) return false;
    }
  return true;
}

void add_other_chart(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index,
                     const Polygon& polygon) {
  const Chart& own = at.surface->charts[at.p.chart];
  const Chart& chart = at.surface->charts[index];
  const ChartIn<double>& formula = chart.in<double>();
  const bool same_piece = at.surface->charts_join_smoothly && own.facts().piece == chart.facts().piece;
  const bool flat = chart.facts().plane.has_value();
  const bool square = polygon.count == 4;

  Parameters apex = nearest_to(at.frame.point, formula, polygon);
  Frame<double> frame = formula.frame(apex);
  TangentPlane plane(frame.tangent_s, frame.tangent_t);
  const double delta = norm(difference(at, index, apex));
  const double extent = norm(frame.point) + norm(at.frame.point) + plane.ss + plane.tt;
  expects(delta > 0 || same_piece, "P off the edges where pieces meet", named("chart", chart.facts().name),
          named("s", at.p.at.s), named("t", at.p.at.t));

  const auto integrand = [&](const Parameters& a) { return cubature.add(other_integrand(at, index, a)); };

  if (chart.facts().singular == SingularLine::s_zero) {
    const bool far = delta > far_away * radius_of(polygon, apex, plane);
    const Spread spread = far ? Spread{} : Spread{.centre = apex.t, .delta = delta / plane.tt};
    add_slabs(cubature, integrand({0, 0}), polygon, {0, 0}, true, spread, graded_roughness);
    return;
  }
  // Where one piece goes on smoothly G is bounded, but nearer than this rounding hides it: that disk is not
  // integrated.
  const double hidden = 1e-8 * extent;
  const bool is_seam =
      same_piece && goes_on_smoothly(at, formula, chart.facts().domain, apex, std::max(delta, hidden));
  if (!is_seam && !(delta > 0))
    throw AccuracyNotReached("Ku at a point of chart " + own.facts().name,
                             "chart " + chart.facts().name + " bends there within what rounding hides");
  const double blind = is_seam ? hidden : 0;
  const double bend = flat ? 0 : bend_of(formula, polygon);
  Polar polar{.delta = std::max(delta, blind), .bend = bend};
  if (delta < blind) {
    polar.inner_radius = 0.3 * blind;
    polar.bound = bound_near(at);
  }
  // In the blind case P stays well inside that disk.
  apex = snapped(apex, polygon, plane, std::max(0.25 * delta, delta < blind ? 0.1 * blind : 0));
  if (delta > far_away * radius_of(polygon, apex, plane)) {
    if (square) {
      add_slabs(cubature, integrand({0, 0}), polygon, {0, 0}, false, {},
                far_roughness(polygon, plane, delta, bend));
    } else {
      add_triangles(cubature, integrand(polygon[0]), polygon, far_roughness(polygon, plane, delta, bend));
    }
    return;
  }
  frame = formula.frame(apex);
  plane = TangentPlane(frame.tangent_s, frame.tangent_t);
  const double strip = add_sectors(cubature, integrand(apex), polygon, apex, plane, polar);
  // G <= 1/|P-Q|^2; across a smooth seam it is bounded, and nothing is lost.
  if (strip > 0 && !is_seam)
    cubature.add_unseen(strip * pi<double>() / delta * std::abs((*at.density)({index, apex}, frame.point)));
}

}  // namespace

Integrand other_integrand(const OperatorPoint& at, std::size_t index, const Parameters& apex) {
  const Chart& chart = at.surface->charts[index];
  const Target target{index, apex};
  if (!chart.facts().plane)
    return CurvedIntegrand{.target = target,
                           .chart = &chart.in<Pack>(),
                           .p = at.frame.point,
                           .normal_p = at.normal,
                           .size_of_p = norm(at.frame.point)};
  const Frame<double> origin = chart.in<double>().frame({0, 0});
  const Point offset = difference(at, index, apex);
  const double extent =
      norm(origin.point) + norm(at.frame.point) + norm(origin.tangent_s) + norm(origin.tangent_t);
  const bool exact = at.surface->charts[at.p.chart].facts().plane.has_value();
  return FlatIntegrand{.target = target,
                       .origin = origin.point,
                       .tangent_s = origin.tangent_s,
                       .tangent_t = origin.tangent_t,
                       .normal_p = at.normal,
                       .offset = offset,
                       .height = -dot(offset, origin.area_normal),
                       .area = area_element(origin),
                       .offset_error = exact ? 2 * roundoff * norm(offset) : 4 * roundoff * extent};
}

void add_part(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index,
              const Polygon& polygon) {
  const Chart& own = at.surface->charts[at.p.chart];
  if (index == at.p.chart) {
    if (!own.facts().flat_in()) add_own_chart(cubature, at, polygon);
  } else if (!in_one_plane(own, at.surface->charts[index])) {
    add_other_chart(cubature, at, index, polygon);
  }
}

}  // namespace radcert::reference
