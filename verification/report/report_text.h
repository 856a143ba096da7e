// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "verification/framework/report.h"

namespace radcert::verification {

/// A report for a terminal.
/// Requires  nothing
/// Result    a line a statement or cell: statement, verdict, recorded, ours with its radius, printed,
///           seconds; below the table what differs from the record and why, and the count of each verdict.
///           `!` stands before what differs. Where such a line is longer than `most_columns`, two lines: the
///           statement; verdict, ours, printed, seconds
/// Limits    figures show six digits, with a radius that encloses what was cut
[[nodiscard]] std::string report_table(const Report& report, std::size_t most_columns = std::string::npos);

/// What a line of evidence observed, for readers: with its radius, or alone where it is exact or where none
/// is known.
[[nodiscard]] std::string observed_text(const Evidence& evidence);

/// A report for readers: a section a paper, evidence and notes written out, in Markdown.
[[nodiscard]] std::string report_markdown(const Report& report, const std::string& command);

/// A report for programs, of the type radcert/verification/1.
/// Source    the JSON Schema of that name
/// Requires  nothing
/// Result    the same bits on every run, apart from `timing` and `command`; null for a number that is not
///           finite
[[nodiscard]] JsonValue report_json(const Report& report, const std::string& command);
[[nodiscard]] std::string report_json_text(const Report& report, const std::string& command);

/// The files of a report in a folder, with their contents: report.json, report.md and report.html.
[[nodiscard]] std::vector<std::pair<std::filesystem::path, std::string>> report_files(
    const Report& report, const std::filesystem::path& folder, const std::string& command);

}  // namespace radcert::verification
