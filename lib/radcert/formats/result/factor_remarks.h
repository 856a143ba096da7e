// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/core/option_name.h"
#include "radcert/formats/result/factors_json.h"

namespace radcert {

/// What is odd about a matrix of factors, and no fault: rows that see nothing, a scene that sees nothing at
/// all.
/// Requires  `style` for what the user may write instead
/// Result    in words, a line each
[[nodiscard]] std::vector<std::string> factor_warnings(const FactorReport& report, OptionStyle style);

/// Why the numbers must not be relied on: rows of a closed scene that do not sum to 1 within their radius, or
/// an accuracy that was demanded and not reached.
/// Result    in words, a line each; none where nothing is wrong
[[nodiscard]] std::vector<std::string> factor_failures(const FactorReport& report,
                                                       const std::optional<double>& demanded,
                                                       OptionStyle style);

}  // namespace radcert
