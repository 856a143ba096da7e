// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>

namespace radcert {

/// Whether a density is 0 at all of these places: then what it sends is 0, and need not be evaluated.
[[nodiscard]] inline bool vanishes(std::span<const double> density) {
  return std::all_of(density.begin(), density.end(), [](double each) { return each == 0; });
}

}  // namespace radcert
