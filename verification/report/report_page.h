// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/experiment.h"
#include "verification/framework/report.h"

namespace radcert::verification {

/// Whether report pages have typeset formulas, plots and views in space: the program was built with Node.
[[nodiscard]] bool has_full_page();

/// A report as one self-contained HTML page.
/// Source    verification/report/web
/// Requires  nothing
/// Result    opens from disk, offline, and asks for nothing else: scripts, styles, fonts and the data are
///           inside. It shows what the report holds and computes no figure. Built without Node: a plain page
///           that has the same statements and says what is missing
/// Limits    pictures are rounded to single precision
[[nodiscard]] std::string report_page(const Report& report, const std::string& command);

/// A result of radcert experiment as such a page: rankings, plots, levels.
/// Source    verification/report/web
/// Requires  a value of the type radcert/experiment_result/1, and what it was made of
/// Result    as report_page; built without Node: a page that names the other files
[[nodiscard]] std::string experiment_page(const JsonValue& document, const Experiment& experiment,
                                          std::span<const Result> results);

}  // namespace radcert::verification
