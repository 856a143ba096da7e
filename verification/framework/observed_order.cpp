// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/observed_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"

namespace radcert::verification {

Approximation exponent_between(const Approximation& coarse, const Approximation& fine, double ratio) {
  expects(ratio > 1, "mesh sizes that fall", named("ratio", ratio));
  const bool settled = coarse.value > coarse.radius && fine.value > fine.radius;
  if (!settled) return {.value = 0, .radius = std::numeric_limits<double>::infinity()};
  // A logarithm of doubles is rounded within some units in its last place.
  constexpr double rounding = 0x1p-50;
  const double value = std::log(coarse.value / fine.value) / std::log(ratio);
  const double low = std::log((coarse.value - coarse.radius) / (fine.value + fine.radius)) / std::log(ratio);
  const double high = std::log((coarse.value + coarse.radius) / (fine.value - fine.radius)) / std::log(ratio);
  return {.value = value,
          .radius = std::max(value - low, high - value) + rounding * (1 + std::abs(value)),
          .guaranteed = coarse.guaranteed && fine.guaranteed};
}

ObservedOrder observed_order(const LevelErrors& errors, const OrderModel& model) {
  expects(errors.errors.size() == errors.mesh_sizes.size(), "an error for each mesh size",
          named("errors", errors.errors.size()));
  expects(model.next > 0, "next > 0", named("next", model.next));
  std::size_t first = 0;
  if (model.logarithm)
    while (first < errors.errors.size() && errors.mesh_sizes[first] >= 1) ++first;
  expects(errors.errors.size() >= first + 3, "three levels at least",
          named("levels", errors.errors.size() - first));
  ObservedOrder order{.exponent = {.value = 0, .radius = 0}, .logarithm = 0};
  Approximation before;
  double approach = 0;
  for (std::size_t k = first + 1; k < errors.errors.size(); ++k) {
    const double ratio = errors.mesh_sizes[k - 1] / errors.mesh_sizes[k];
    Approximation now = exponent_between(errors.errors[k - 1], errors.errors[k], ratio);
    if (model.logarithm)
      order.logarithm =
          std::log(std::log(errors.mesh_sizes[k]) / std::log(errors.mesh_sizes[k - 1])) / std::log(ratio);
    now.value += order.logarithm;
    const double nearer = std::pow(ratio, model.next);
    const double difference = std::abs(now.value - before.value) + now.radius + before.radius;
    if (k > first + 1) approach = std::max(approach / nearer, difference / (nearer - 1));
    order.exponent = {.value = now.value, .radius = now.radius + approach};
    before = now;
  }
  return order;
}

}  // namespace radcert::verification
