// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "radcert/formats/json/json_value.h"

namespace radcert::verification {

/// A TOML document as a JSON value, for JsonReader, and the lines that its values stand in.
/// Source    TOML 1.0
/// Requires  made by parse_toml
/// Result    tables are objects with their keys in the order of the file
struct TomlDocument {
  JsonValue value;
  std::map<std::string, int> lines;  ///< by JSON pointer, counted from 1

  /// The line of the value at a pointer; of one that is missing, of what it is missing from.
  [[nodiscard]] int line_of(std::string pointer) const;
};

/// A document of unknown origin.
/// Requires  `source` names the text in messages
/// Result    the document; InputError with source and line for a text that is no TOML, and for what JSON does
///           not have: dates, times, numbers that are not finite
[[nodiscard]] TomlDocument parse_toml(std::string_view text, const std::string& source);

}  // namespace radcert::verification
