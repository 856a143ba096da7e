// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "records/reference_records.h"

namespace radcert::app {

/// A reference value by its name, whatever its kind: one value, a member of a family, a mean of a continuous
/// solution.
/// Requires  digits from anywhere; 20 where none are asked for, and of means what their certificates prove
/// Result    the record, its radius at most 10^-digits. InputError for a name, a parameter or a number of
///           digits that is not allowed, AccuracyNotReached where a route or a certificate falls short of it
[[nodiscard]] ReferenceRecord requested_reference(const std::string& name,
                                                  const std::vector<Setting>& settings,
                                                  const std::optional<std::int64_t>& digits);

}  // namespace radcert::app
