// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/error_order.h"

#include <cmath>

namespace radcert {

bool stands_above_radius(const Approximation& error) {
  constexpr double largest_relative_radius = 0.05;
  return error.value > 0 && std::isfinite(error.value) &&
         error.radius <= largest_relative_radius * error.value;
}

std::optional<double> error_ratio(const std::optional<Approximation>& before,
                                  const std::optional<Approximation>& now) {
  if (!before || !now || !stands_above_radius(*before) || !stands_above_radius(*now)) return std::nullopt;
  return before->value / now->value;
}

std::optional<double> error_order(const std::optional<Approximation>& before, double h_before,
                                  const std::optional<Approximation>& now, double h_now) {
  const std::optional<double> ratio = error_ratio(before, now);
  if (!ratio || !(h_before > h_now)) return std::nullopt;
  return std::log(*ratio) / std::log(h_before / h_now);
}

}  // namespace radcert
