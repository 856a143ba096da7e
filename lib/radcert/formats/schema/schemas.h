// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace radcert {

/// The file types that radcert reads or writes.
/// Source    the files formats/schema/*.json, in the order of lib/CMakeLists.txt
/// Result    their names in a fixed order: "problem" for files with the schema "radcert/problem/1"
std::vector<std::string> schema_names();

/// The JSON Schema of a file type.
/// Source    formats/schema/<name>.json; JSON Schema draft 2020-12
/// Requires  a name of schema_names(), else ContractViolation
/// Result    what this version reads and writes, no more. Where the file has {"$catalogue": "solvers"}, the
///           value of catalogue_json; where it has {"$part": "problem#/properties/surface"}, that part of
///           another schema
/// Limits    a schema knows single values: what only the whole shows, the program refuses
std::string schema_text(std::string_view name);

}  // namespace radcert
