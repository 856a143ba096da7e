// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "radcert/study/result.h"

namespace radcert {

/// A fitted order for people.
/// Maths     two decimals; with the spread of the slopes between levels, rounded up after the order has been
///           rounded
/// Result    "3.99", then `plus_minus` and "0.12" where three levels or more have a finite spread: two levels
///           have one slope. None where no finite order was fitted
/// Limits    the spread is an estimate
[[nodiscard]] std::optional<std::string> fitted_order_text(const OrderFit& fit, std::string_view plus_minus);

}  // namespace radcert
