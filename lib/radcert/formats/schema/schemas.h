// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace radcert {

/// The JSON Schema of a file type.
struct Schema {
  std::string_view name;     ///< "problem", for files with the schema "radcert/problem/1"
  std::string_view summary;  ///< one line
  std::string_view text;     ///< JSON, draft 2020-12
};

/// The file types that radcert reads or writes.
/// Maths     none
/// Source    the file formats; JSON Schema draft 2020-12
/// Requires  nothing
/// Result    in a fixed order; what this version reads and writes, no more
/// Limits    a schema knows single values: what only the whole shows, the program refuses
std::span<const Schema> schemas();

/// The schema of that name, or null.
const Schema* find_schema(std::string_view name);

}  // namespace radcert
