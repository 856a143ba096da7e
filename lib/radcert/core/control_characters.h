// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace radcert {

/// Whether a name has characters that would do more on a terminal than name something.
/// Requires  nothing
/// Result    true of bytes below a space, of 0x7f, and of U+0080 to U+009F in UTF-8
[[nodiscard]] inline bool has_control_characters(std::string_view name) {
  for (std::size_t k = 0; k < name.size(); ++k) {
    const auto byte = static_cast<unsigned char>(name[k]);
    if (byte < 0x20 || byte == 0x7f) return true;
    if (byte == 0xc2 && k + 1 < name.size() && static_cast<unsigned char>(name[k + 1]) < 0xa0) return true;
  }
  return false;
}

}  // namespace radcert
