// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/efficiency.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

void require_positive(std::span<const CostPoint> points) {
  for (const CostPoint& point : points)
    expects(point.cost > 0 && point.error > 0 && std::isfinite(point.cost) && std::isfinite(point.error),
            "positive finite costs and errors", named("cost", point.cost), named("error", point.error));
}

/// The points whose cost exceeds every cost before.
std::vector<CostPoint> ascending(std::span<const CostPoint> points) {
  std::vector<CostPoint> out;
  for (const CostPoint& point : points)
    if (out.empty() || point.cost > out.back().cost) out.push_back(point);
  return out;
}

double dearest(const std::vector<CostPoint>& points) {
  double cost = 0;
  for (const CostPoint& point : points) cost = std::max(cost, point.cost);
  return cost;
}

}  // namespace

std::optional<PowerLaw> power_law(std::span<const CostPoint> points) {
  require_positive(points);
  const auto count = static_cast<double>(points.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const CostPoint& point : points) {
    mean_x += std::log(point.cost) / count;
    mean_y += std::log(point.error) / count;
  }
  double xx = 0;
  double xy = 0;
  bool different = false;
  for (const CostPoint& point : points) {
    const double x = std::log(point.cost) - mean_x;
    xx += x * x;
    xy += x * (std::log(point.error) - mean_y);
    different = different || point.cost != points.front().cost;
  }
  if (!different || !(xx > 0)) return std::nullopt;
  PowerLaw law{.exponent = xy / xx, .halfwidth = {}};
  if (points.size() == 2) return law;
  double halfwidth = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = std::log(points[i].cost / points[i - 1].cost);
    if (step == 0) continue;
    const double slope = std::log(points[i].error / points[i - 1].error) / step;
    halfwidth = std::max(halfwidth, std::abs(slope - law.exponent));
  }
  law.halfwidth = halfwidth;
  return law;
}

AsymptoticLaw asymptotic_law(std::span<const CostPoint> points) {
  constexpr std::size_t fewest = 3;
  constexpr double steady = 0.5;
  constexpr double relatively_steady = 0.25;
  if (points.size() < fewest) return {.from = 0, .law = power_law(points)};
  for (std::size_t from = 0; from + fewest <= points.size(); ++from) {
    const std::optional<PowerLaw> law = power_law(points.subspan(from));
    if (law && *law->halfwidth <= std::max(steady, relatively_steady * std::abs(law->exponent)))
      return {.from = from, .law = law};
  }
  return {.from = points.size(), .law = std::nullopt};
}

std::optional<double> error_at(std::span<const CostPoint> points, double cost) {
  require_positive(points);
  const std::vector<CostPoint> curve = ascending(points);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].cost == cost) return curve[i].error;
    if (i == 0 || !(curve[i - 1].cost < cost && cost < curve[i].cost)) continue;
    const double part = std::log(cost / curve[i - 1].cost) / std::log(curve[i].cost / curve[i - 1].cost);
    return std::exp((1 - part) * std::log(curve[i - 1].error) + part * std::log(curve[i].error));
  }
  return std::nullopt;
}

std::optional<EqualCost> at_equal_cost(std::span<const std::vector<CostPoint>> methods) {
  std::optional<double> cost;
  for (const std::vector<CostPoint>& points : methods)
    if (!points.empty()) cost = std::min(cost.value_or(dearest(points)), dearest(points));
  if (!cost) return std::nullopt;
  EqualCost out{.cost = *cost, .errors = {}, .order = std::vector<std::size_t>(methods.size())};
  for (const std::vector<CostPoint>& points : methods) out.errors.push_back(error_at(points, *cost));
  std::iota(out.order.begin(), out.order.end(), std::size_t{0});
  std::stable_sort(out.order.begin(), out.order.end(), [&](std::size_t a, std::size_t b) {
    if (!out.errors[a] || !out.errors[b]) return out.errors[a].has_value() && !out.errors[b].has_value();
    return *out.errors[a] < *out.errors[b];
  });
  return out;
}

}  // namespace radcert
