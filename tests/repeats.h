// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace radcert::test {

/// How often something is tried: as often as usual, RADCERT_LAWS times as often where that is set.
inline std::size_t repeats(std::size_t usual) {
  const char* const factor = std::getenv("RADCERT_LAWS");
  return usual * (factor == nullptr ? 1 : static_cast<std::size_t>(std::max(1L, std::atol(factor))));
}

}  // namespace radcert::test
