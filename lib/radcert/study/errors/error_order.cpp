// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/error_order.h"

#include <cmath>

namespace radcert {

std::optional<double> error_ratio(const std::optional<Approximation>& before,
                                  const std::optional<Approximation>& now) {
  if (!before || !now || !(now->value > 0)) return std::nullopt;
  return before->value / now->value;
}

std::optional<double> error_order(const std::optional<Approximation>& before, double h_before,
                                  const std::optional<Approximation>& now, double h_now) {
  const std::optional<double> ratio = error_ratio(before, now);
  if (!ratio || !(*ratio > 0) || !(h_before > h_now)) return std::nullopt;
  return std::log(*ratio) / std::log(h_before / h_now);
}

}  // namespace radcert
