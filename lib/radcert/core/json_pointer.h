// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace radcert {

/// A place in a JSON document, one step deeper: errors name places so, whoever finds them.
/// Source    RFC 6901
/// Result    the pointer with "/key" appended, "~" and "/" in the key escaped
[[nodiscard]] inline std::string pointer_below(const std::string& pointer, std::string_view key) {
  std::string out = pointer + "/";
  for (const char c : key) {
    if (c == '~')
      out += "~0";
    else if (c == '/')
      out += "~1";
    else
      out += c;
  }
  return out;
}
[[nodiscard]] inline std::string pointer_below(const std::string& pointer, std::size_t place) {
  return pointer + "/" + std::to_string(place);
}

}  // namespace radcert
