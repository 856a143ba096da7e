// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/problem.h"

namespace radcert {

/// A problem file.
/// Source    the file format radcert/problem/1
/// Requires  a file of at most 64 MiB, nested at most 64 deep
/// Result    the problem, numbers and expressions exact, defaults filled in; otherwise InputError with file,
///           JSON pointer, value and what is allowed. "superconvergent" has become the alpha that it stands
///           for
/// Limits    syntax, names, types and ranges of single values; check() refuses what only the whole shows
Problem read_problem(const std::filesystem::path& path);

/// The same from a text; `source` names it in messages.
Problem parse_problem(std::string_view text, const std::string& source);

/// The same from a document of a program's own, whose surface and method may stand beside it.
/// Requires  `surface` is checked: a name of the catalogue with admissible parameters, or a mesh; `method`:
///           one that read_method could have made
/// Result    where `surface` is given, the document has no key `surface`, where `method` is, no key `basis`;
///           else as parse_problem
Problem problem_of(const JsonValue& document, const std::string& source,
                   const std::optional<SurfaceChoice>& surface = std::nullopt,
                   const std::optional<Method>& method = std::nullopt);

/// A problem as JSON, every default written out.
/// Maths     parse_problem(problem_text(p)) states the same problem as p
/// Source    the file format radcert/problem/1
/// Requires  a problem that parse_problem could have made
/// Result    canonical: equal problems give equal texts; what no double holds is a string, "1/6"
/// Limits    a decimal is written as a fraction: "0.1" comes back as "1/10"
JsonValue problem_json(const Problem& problem);

/// problem_json as text, ending with a newline.
std::string problem_text(const Problem& problem);

}  // namespace radcert
