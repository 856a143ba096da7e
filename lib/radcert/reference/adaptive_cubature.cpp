// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/adaptive_cubature.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert::reference {
namespace {

constexpr double tolerance = 4e-14;         // what the adaptive rule aims at, relative to Int |G u|
constexpr std::size_t region_limit = 4000;  // a density that is not smooth must not run for ever
constexpr double rounding = 32 * roundoff;  // of one G J u and of its share in the sum, relatively

}  // namespace

AdaptiveCubature::AdaptiveCubature() : rule_(rule()) {}

const KronrodRule& AdaptiveCubature::rule() {
  static const KronrodRule the_rule;
  return the_rule;
}

template <class Kind, class Item>
std::uint32_t AdaptiveCubature::add(std::vector<Place<Kind>>& places, std::vector<Item>& items,
                                    const Item& item, Kind kind) {
  places.push_back({kind, items.size()});
  items.push_back(item);
  return static_cast<std::uint32_t>(places.size() - 1);
}

std::uint32_t AdaptiveCubature::add(const FlatIntegrand& f) {
  return add(integrands_, flat_, f, IntegrandKind::flat);
}

std::uint32_t AdaptiveCubature::add(const CurvedIntegrand& f) {
  return add(integrands_, curved_, f, IntegrandKind::curved);
}

std::uint32_t AdaptiveCubature::add(const ChordIntegrand& f) {
  return add(integrands_, chord_, f, IntegrandKind::chord);
}

void AdaptiveCubature::add(const Collapse& map, std::uint32_t integrand) {
  first(add(maps_, collapse_, map, MapKind::collapse), integrand);
}

void AdaptiveCubature::add(const Sector& map, std::uint32_t integrand) {
  first(add(maps_, sector_, map, MapKind::sector), integrand);
}

void AdaptiveCubature::add(const Slab& map, std::uint32_t integrand) {
  first(add(maps_, slab_, map, MapKind::slab), integrand);
}

void AdaptiveCubature::add_unseen(double bound) { unseen_ += bound; }

template <class Action>
auto AdaptiveCubature::with_integrand(std::uint32_t integrand, const Action& action) const {
  const Place<IntegrandKind>& place = integrands_[integrand];
  switch (place.kind) {
    case IntegrandKind::flat: return action(flat_[place.index]);
    case IntegrandKind::curved: return action(curved_[place.index]);
    default: return action(chord_[place.index]);
  }
}

template <class Map, class Integrand>
void AdaptiveCubature::apply(const Map& map, const Integrand& f, Region& region) const {
  constexpr std::size_t n = KronrodRule::size;
  const KronrodRule::Samples& nodes = rule_.nodes();
  const KronrodRule::Samples& weights = rule_.weights();
  KronrodRule::Samples profile_x{};
  KronrodRule::Samples profile_y{};
  double absolute = 0;
  double noise = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto line = map.line(region.x + nodes[i] * region.width);
    double row = 0;
    double row_absolute = 0;
    double row_noise = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const MapPoint point = line.at(region.y + nodes[j] * region.height);
      const Sample sample = f(point.w);
      const double value = sample.value * point.area;
      row += weights[j] * value;
      row_absolute += weights[j] * std::abs(value);
      row_noise += weights[j] * sample.noise * std::abs(point.area);
      profile_y[j] += weights[i] * value;
    }
    profile_x[i] = row;
    absolute += weights[i] * row_absolute;
    noise += weights[i] * row_noise;
  }
  const double area = region.width * region.height;
  region.value = area * rule_.integral(profile_x);
  region.absolute = area * absolute;
  region.noise = area * noise;
  region.error_x = area * rule_.error(profile_x);
  region.error_y = area * rule_.error(profile_y);
  expects(std::isfinite(region.absolute) && std::isfinite(region.noise), "G u is finite off P",
          named("integral of |G u| over a part", region.absolute));
  // No bisection lowers an error that is rounding.
  const bool is_rounding = region.error() <= 2 * region.noise + 8 * roundoff * region.absolute;
  const bool is_tiny = region.width < 1e-12 || region.height < 1e-12;
  region.priority = is_rounding || is_tiny ? 0 : region.error();
}

void AdaptiveCubature::apply(Region& region) const {
  const Place<MapKind>& place = maps_[region.map];
  with_integrand(region.integrand, [&](const auto& f) {
    switch (place.kind) {
      case MapKind::collapse: return apply(collapse_[place.index], f, region);
      case MapKind::sector: return apply(sector_[place.index], f, region);
      case MapKind::slab: return apply(slab_[place.index], f, region);
    }
  });
}

void AdaptiveCubature::first(std::uint32_t map, std::uint32_t integrand) {
  Region region{};
  region.map = map;
  region.integrand = integrand;
  region.width = region.height = 1;
  apply(region);
  regions_.push_back(region);
}

Estimate AdaptiveCubature::estimate() {
  const auto less = [](const Region& a, const Region& b) { return a.priority < b.priority; };
  std::make_heap(regions_.begin(), regions_.end(), less);
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
  while (!regions_.empty() && regions_.size() < region_limit) {
    if (error <= allowed) {
      resum();
      if (error <= allowed) break;
    }
    if (regions_.front().priority == 0) break;
    std::pop_heap(regions_.begin(), regions_.end(), less);
    Region low = regions_.back();
    regions_.pop_back();
    error -= low.error();
    allowed -= allowance(low);
    Region high = low;
    if (low.error_x > low.error_y) {
      low.width *= 0.5;
      high.width -= low.width;
      high.x += low.width;
    } else {
      low.height *= 0.5;
      high.height -= low.height;
      high.y += low.height;
    }
    for (Region region : {low, high}) {
      apply(region);
      error += region.error();
      allowed += allowance(region);
      regions_.push_back(region);
      std::push_heap(regions_.begin(), regions_.end(), less);
    }
  }
  Estimate result;
  double noise = unseen_;
  double carry = 0;
  for (const Region& region : regions_) {
    const double sum = result.value + region.value;
    carry += std::abs(result.value) >= std::abs(region.value) ? (result.value - sum) + region.value
                                                              : (region.value - sum) + result.value;
    result.value = sum;
    result.absolute += region.absolute;
    noise += region.noise + region.error();
  }
  result.value += carry;
  result.radius = noise + rounding * result.absolute;
  return result;
}

}  // namespace radcert::reference
