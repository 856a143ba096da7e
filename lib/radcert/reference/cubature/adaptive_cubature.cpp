// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/cubature/adaptive_cubature.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"

namespace radcert::reference {
namespace {

constexpr double tolerance = 4e-14;  // what the adaptive rule aims at, relative to Int |G u|
// A density that is not smooth must not run for ever.
const WorkLimit region_limit("reference/adaptive_cubature: regions", 4000, 0,
                             "what is left of the estimated errors goes into the radius");
constexpr double rounding = 32 * roundoff;  // of one G J u and of its share in the sum, relatively

constexpr std::size_t lanes = Pack::lanes;

/// Eight entries of an array.
template <std::size_t n>
Pack entries(const std::array<double, n>& a, std::size_t from) {
  return Pack::load(a.data() + from);
}

/// How many points bring an error down to a goal if the fall of the coefficients goes on; more than there are
/// where it does not.
std::size_t enough_points(std::size_t points, const GaussRule::Error& error, double goal) {
  constexpr std::size_t too_many = GaussRule::largest + 1;
  if (!(error.decay < 0.5) || goal <= 0) return too_many;
  const double more =
      std::max(1.0, std::ceil(std::log(goal / error.value) / std::log(std::max(error.decay, 1e-3))));
  return more < too_many ? points + 1 + static_cast<std::size_t>(more) : too_many;
}

/// Points that are evaluated together, and what is found there.
struct Workspace {
  static constexpr std::size_t capacity = 256;
  using Array = std::array<double, capacity>;
  Array s, t, x, y, z;
  Array kernel;  // G times the area elements of chart and map
  Array noise;   // of the kernel
  Array u;
};

}  // namespace

std::size_t AdaptiveCubature::add(const Integrand& f) {
  integrands_.push_back(f);
  return integrands_.size() - 1;
}

template <class OfMap, class OfIntegrand>
void AdaptiveCubature::apply(const OfMap& map, const Part& part, const OfIntegrand& f, Region& region) const {
  constexpr std::size_t most = GaussRule::largest;
  const GaussRule& across = GaussRule::of(region.lines);
  const GaussRule& along = GaussRule::of(region.points);
  const std::size_t stride = padded<double>(region.points);

  std::array<Pack, most / lanes> position;
  std::array<Pack, most / lanes> slope;
  for (std::size_t k = 0; k * lanes < stride; ++k) {
    const Spacing::Values g = part.spacing(fma(entries(along.nodes(), k * lanes), region.width, region.x));
    position[k] = g.position;
    slope[k] = g.slope;
  }

  Workspace work;
  RegionSums sums(region);
  const std::size_t block = Workspace::capacity / stride;  // lines
  Line<Pack> lines{};
  for (std::size_t first = 0; first < region.lines; first += block) {
    const std::size_t last = std::min(first + block, region.lines);
    std::size_t place = 0;
    for (std::size_t i = first; i < last; ++i) {
      if (i % lanes == 0 || i == first)
        lines = map.line(fma(entries(across.nodes(), i / lanes * lanes), region.height, region.y));
      const std::size_t lane = i % lanes;
      const Line<double> line{{lines.base.s.lane(lane), lines.base.t.lane(lane)},
                              {lines.direction.s.lane(lane), lines.direction.t.lane(lane)},
                              lines.start.lane(lane),
                              lines.extent.lane(lane),
                              lines.factor.lane(lane)};
      const auto& sample = f.on(line);
      for (std::size_t k = 0; k * lanes < stride; ++k, place += lanes) {
        const Pack r = fma(position[k], line.extent, line.start);
        Pack area = slope[k] * (line.factor * line.extent);
        if (OfMap::from_one_point) area = area * r;
        const Samples q = sample(r);
        q.at.s.store(work.s.data() + place);
        q.at.t.store(work.t.data() + place);
        q.point.x.store(work.x.data() + place);
        q.point.y.store(work.y.data() + place);
        q.point.z.store(work.z.data() + place);
        (q.kernel * area).store(work.kernel.data() + place);
        (q.noise * abs(area)).store(work.noise.data() + place);
      }
    }
    density_({f.target.chart,
              {work.s.data(), place},
              {work.t.data(), place},
              {work.x.data(), place},
              {work.y.data(), place},
              {work.z.data(), place}},
             {work.u.data(), place});
    for (std::size_t i = first; i < last; ++i)
      sums.add_line(i, [&, from = (i - first) * stride](std::size_t k) {
        const Pack u = entries(work.u, from + k);
        return RegionSums::Term{entries(work.kernel, from + k) * u, entries(work.noise, from + k) * abs(u)};
      });
  }
  sums.finish(region, part.analytic ? usual_caution : usual_caution + 1);
  expects(std::isfinite(region.absolute) && std::isfinite(region.noise), "G u is finite off P",
          named("integral of |G u| over a part", region.absolute));
}

void AdaptiveCubature::apply(Region& region) {
  Part& part = parts_[region.part];
  if (!part.integrand) part.integrand = add(far_(part.far_chart));
  std::visit([&](const auto& map, const auto& f) { apply(map, part, f, region); }, part.map,
             integrands_[*part.integrand]);
}

void AdaptiveCubature::add(const Map& map, const Spacing& spacing, const Roughness& roughness,
                           std::size_t integrand) {
  parts_.push_back({map, spacing, integrand, 0, roughness.analytic});
  const Cut across = cut_across(roughness);
  const Cut along = cut_along(roughness);
  for (std::size_t i = 0; i < across.regions; ++i)
    for (std::size_t j = 0; j < along.regions; ++j) {
      Region region{};
      region.part = parts_.size() - 1;
      region.lines = across.points;
      region.points = along.points;
      region.height = 1 / static_cast<double>(across.regions);
      region.width = 1 / static_cast<double>(along.regions);
      region.y = static_cast<double>(i) * region.height;
      region.x = static_cast<double>(j) * region.width;
      apply(region);
      regions_.push_back(region);
    }
}

void AdaptiveCubature::add(const Map& map, std::size_t chart, Region known) {
  known.part = parts_.size();
  parts_.push_back({map, {}, std::nullopt, chart, true});
  regions_.push_back(known);
}

void AdaptiveCubature::refine() {
  const auto less = [](const Region& a, const Region& b) {
    return (a.is_final() ? 0 : a.error()) < (b.is_final() ? 0 : b.error());
  };
  double error = 0;
  double allowed = 0;  // rounding bounds what is worth asking for
  const auto allowance = [](const Region& region) { return tolerance * region.absolute + region.noise; };
  const auto resum = [&] {
    error = allowed = 0;
    for (const Region& region : regions_) {
      error += region.error();
      allowed += allowance(region);
    }
  };
  resum();
  if (error <= allowed) return;
  std::make_heap(regions_.begin(), regions_.end(), less);
  const std::size_t most = region_limit.count();
  while (regions_.size() < most) {
    if (error <= allowed) {
      resum();
      if (error <= allowed) return;
    }
    if (regions_.front().is_final()) return;
    std::pop_heap(regions_.begin(), regions_.end(), less);
    Region low = regions_.back();
    regions_.pop_back();
    error -= low.error();
    allowed -= allowance(low);
    const auto put = [&](Region region) {
      apply(region);
      error += region.error();
      allowed += allowance(region);
      regions_.push_back(region);
      std::push_heap(regions_.begin(), regions_.end(), less);
    };
    const bool is_across = low.across.value > low.along.value;
    std::size_t& points = is_across ? low.lines : low.points;
    const std::size_t enough = enough_points(points, is_across ? low.across : low.along, 0.1 * allowed);
    if (enough <= GaussRule::largest && 3 * enough < 5 * points) {
      points = is_across ? enough : padded<double>(enough);
      put(low);
      continue;
    }
    Region high = low;
    if (is_across) {
      low.height *= 0.5;
      high.height -= low.height;
      high.y += low.height;
    } else {
      low.width *= 0.5;
      high.width -= low.width;
      high.x += low.width;
    }
    put(low);
    put(high);
  }
}

Approximation AdaptiveCubature::estimate() {
  refine();
  double value = 0;
  double carry = 0;
  double noise = unseen_;
  double absolute = 0;  // of the absolute value of the integrand
  for (const Region& region : regions_) {
    const double sum = value + region.value;
    carry += std::abs(value) >= std::abs(region.value) ? (value - sum) + region.value
                                                       : (region.value - sum) + value;
    value = sum;
    absolute += region.absolute;
    noise += region.noise + region.error();
  }
  return Approximation::estimated(value + carry, noise + rounding * absolute);
}

}  // namespace radcert::reference
