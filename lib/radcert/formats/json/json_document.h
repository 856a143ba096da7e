// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "radcert/core/json_pointer.h"
#include "radcert/formats/json/json_value.h"

namespace radcert {

/// JSON of unknown origin.
/// Source    RFC 8259
/// Requires  nothing: the text may be empty, cut off, binary, not UTF-8 or nested 100,000 times
/// Result    the value; otherwise InputError with the source and, for a text that is no JSON, line, column
///           and byte; keys that occur twice in one object are refused with their pointer
/// Limits    nesting of at most json_depth_limit; a number beyond the range of double is refused
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& source);

/// The same from a file of at most json_size_limit bytes.
[[nodiscard]] JsonValue read_json(const std::filesystem::path& path);

/// The deepest nesting that is read, and the largest file in bytes.
inline constexpr std::size_t json_depth_limit = 64;
inline constexpr std::uint64_t json_size_limit = std::uint64_t{64} << 20;

/// The first keys of a document that radcert writes.
/// Source    the schemas of formats/schema
/// Result    {"schema": "radcert/<type>/1", "radcert": the version, "command": as given}
[[nodiscard]] JsonValue document_head(const std::string& type, const std::string& command);

/// A text of unknown origin, as a file that is UTF-8 can have it: a name of a file, of a group, a command.
/// Source    RFC 3629
/// Requires  nothing
/// Result    the text itself where it is UTF-8; else U+FFFD in the place of each byte that is not
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace radcert
