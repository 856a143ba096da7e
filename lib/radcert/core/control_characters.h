// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

namespace radcert {

/// Whether a name has characters that would do more on a terminal than name something.
/// Requires  nothing
/// Result    true of bytes below a space and of 0x7f
[[nodiscard]] inline bool has_control_characters(std::string_view name) {
  return std::any_of(name.begin(), name.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
}

}  // namespace radcert
