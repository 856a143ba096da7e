// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "origin.h"
#include "verification/framework/report.h"

namespace radcert::app {

/// What a report leaves for a paper: errors.csv with the levels of the problems that its checks solved,
/// table.tex with statements and verdicts, and plots of the errors, plot.tex and an SVG a problem, where
/// there are some.
Files verify_files(const verification::Report& report, const std::filesystem::path& folder);

}  // namespace radcert::app
