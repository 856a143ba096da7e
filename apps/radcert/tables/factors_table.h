// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/formats/result/factors_json.h"

namespace radcert::app {

/// The rows of a matrix for people, each number with its radius, then what holds for all of it.
std::string factors_table(const FactorReport& report);

/// The largest differences from factors of another source.
std::string comparison_table(const std::vector<FactorComparison>& pairs);

}  // namespace radcert::app
