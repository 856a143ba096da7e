// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/far_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <variant>

#include "radcert/core/contract.h"
#include "radcert/reference/cubature/kernel_integrands.h"
#include "radcert/reference/cubature/roughness.h"

namespace radcert::reference {
namespace {

constexpr std::size_t lanes = Pack::lanes;

/// The arrays of FarSamples.
enum Array : std::size_t { x, y, z, normal_x, normal_y, normal_z, area, array_count };

/// The map of the whole domain, with its apex at (0,0).
Map whole(ChartDomain domain) {
  if (domain == ChartDomain::unit_triangle) return Collapse{{1, 0}, {-1, 1}, 1};
  Slab slab{};
  slab.to_z = slab.to_s = 1;
  slab.upper_from = slab.upper_to = 1;
  return slab;
}

}  // namespace

FarSamples::FarSamples(const Chart& chart, std::size_t index, const Map& map, std::size_t lines,
                       std::size_t points, const Density& u)
    : lines_(lines), points_(points), numbers_(array_count * lines * points) {
  expects(points % lanes == 0, "full packs", named("points", points));
  const GaussRule& across = GaussRule::of(lines);
  const GaussRule& along = GaussRule::of(points);
  const std::size_t count = lines * points;
  std::vector<double> s(count);
  std::vector<double> t(count);
  std::vector<double> values(count);
  const auto array = [&](Array a) { return numbers_.data() + a * count; };
  Pack reach = 0.0;
  std::size_t place = 0;
  std::visit(
      [&](const auto& of_map) {
        for (const std::size_t i : std::views::iota(std::size_t{0}, lines)) {
          const Line<Pack> line = of_map.line(across.nodes()[i]);
          for (std::size_t k = 0; k < points; k += lanes, place += lanes) {
            const Pack r = fma(Pack::load(along.nodes().data() + k), line.extent, line.start);
            Pack factor = line.factor * line.extent;
            if (of_map.from_one_point) factor = factor * r;
            const ParameterPoint<Pack> at = Target{index, {0, 0}}.at(
                {fma(r, line.direction.s, line.base.s), fma(r, line.direction.t, line.base.t)});
            const Frame<Pack> frame = chart.in<Pack>().frame(at);
            reach =
                max(reach, norm(frame.point) + norm(frame.tangent_s) * at.s + norm(frame.tangent_t) * at.t);
            at.s.store(s.data() + place);
            at.t.store(t.data() + place);
            frame.point.x.store(array(x) + place);
            frame.point.y.store(array(y) + place);
            frame.point.z.store(array(z) + place);
            (factor * frame.area_normal.x).store(array(normal_x) + place);
            (factor * frame.area_normal.y).store(array(normal_y) + place);
            (factor * frame.area_normal.z).store(array(normal_z) + place);
          }
        }
      },
      map);
  reach_ = reach.largest();
  u({index, s, t, {array(x), count}, {array(y), count}, {array(z), count}}, values);
  for (std::size_t i = 0; i < count; ++i) {
    expects(std::isfinite(values[i]), "u is finite", named("u", values[i]));
    for (const Array a : {normal_x, normal_y, normal_z}) array(a)[i] *= values[i];
    array(area)[i] = norm(Vector<double>{array(normal_x)[i], array(normal_y)[i], array(normal_z)[i]});
  }
}

Region FarSamples::region(const Vector<double>& p, const Vector<double>& normal_p, double size_of_p) const {
  Region region{};
  region.lines = lines_;
  region.points = points_;
  region.width = region.height = 1;
  RegionSums sums(region);
  const std::size_t count = lines_ * points_;
  const Vector<Pack> from = broadcast(p);
  const Vector<Pack> towards = broadcast(normal_p);
  for (std::size_t i = 0; i < lines_; ++i)
    sums.add_line(i, [&, line = numbers_.data() + i * points_](std::size_t k) {
      const auto entry = [&](Array a) { return Pack::load(line + a * count + k); };
      const Vector<Pack> d = Vector<Pack>{entry(x), entry(y), entry(z)} - from;
      const Pack squared = fused_dot(d, d);
      const Pack weight = 1.0 / (squared * squared);
      const Pack cosine_p = fused_dot(d, towards);
      const Pack cosine_q = -fused_dot(d, {entry(normal_x), entry(normal_y), entry(normal_z)});
      const Pack shift = 2 * roundoff * fma(taxicab_norm(d), 2.0, size_of_p + reach_);
      return RegionSums::Term{cosine_p * cosine_q * weight,
                              shift * weight * fma(entry(area), abs(cosine_p) + shift, abs(cosine_q))};
    });
  sums.finish(region, usual_caution);
  return region;
}

FarChart::FarChart(const Chart& chart, std::size_t index, const Density& u, std::size_t bytes)
    : map_(whole(chart.facts().domain)) {
  const bool triangular = chart.facts().domain == ChartDomain::unit_triangle;
  const Polygon domain = whole_domain(chart.facts().domain);
  Parameters middle{0, 0};
  for (std::size_t i = 0; i < domain.count; ++i) middle = middle + domain[i];
  middle = (1 / static_cast<double>(domain.count)) * middle;
  const ChartIn<double>& formula = chart.in<double>();
  const Frame<double> centre = formula.frame(middle);
  centre_ = centre.point;
  normal_ = unit_normal(centre);
  for (std::size_t i = 0; i < domain.count; ++i)
    for (const Parameters& at : {domain[i], 0.5 * (domain[i] + domain[i + 1])}) {
      const Frame<double> frame = formula.frame(at);
      radius_ = std::max(radius_, norm(frame.point - centre_));
      const double s_extent = norm(frame.tangent_s);
      const double t_extent = norm(frame.tangent_t);
      extent_across_ =
          std::max(extent_across_, triangular ? norm(frame.tangent_t - frame.tangent_s) : s_extent);
      extent_along_ = std::max(extent_along_, triangular ? std::max(s_extent, t_extent) : t_extent);
      bend_ = std::max(bend_, 1.5 * norm(unit_normal(frame) - normal_));
    }
  if (chart.facts().singular != SingularLine::none) return;
  constexpr std::array<std::array<std::size_t, 2>, 4> sizes{{{8, 8}, {12, 16}, {18, 24}, {26, 32}}};
  std::size_t used = 0;
  for (const auto& [lines, points] : sizes) {
    used += array_count * lines * points * sizeof(double);
    if (used <= bytes) samples_.emplace_back(chart, index, map_, lines, points, u);
  }
}

const FarSamples* FarChart::samples_for(const Vector<double>& p) const {
  const double distance = norm(p - centre_) - radius_;
  if (!(distance > 0.5 * radius_)) return nullptr;
  constexpr double margin = 1.2;  // many parts have little error each, and a part that is refined costs more
  const Roughness roughness{.across = std::hypot(margin * extent_across_ / distance, bend_),
                            .along = std::hypot(margin * extent_along_ / distance, bend_)};
  const Cut across = cut_across(roughness);
  const Cut along = cut_along(roughness);
  if (across.regions > 1 || along.regions > 1) return nullptr;
  for (const FarSamples& samples : samples_)
    if (across.points <= samples.lines() && along.points <= samples.points()) return &samples;
  return nullptr;
}

bool may_lie_in_one_plane(const FarChart& a, const FarChart& b) {
  constexpr double slack = 1e-6;
  const Vector<double> between = b.centre_ - a.centre_;
  const double size = std::abs(a.centre_.x) + std::abs(a.centre_.y) + std::abs(a.centre_.z) + norm(between);
  return std::abs(dot(a.normal_, b.normal_)) > 1 - slack && std::abs(dot(a.normal_, between)) <= slack * size;
}

}  // namespace radcert::reference
