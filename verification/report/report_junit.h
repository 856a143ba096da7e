// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "verification/framework/report.h"

namespace radcert::verification {

/// A report for those who gather test results: JUnit's XML.
/// Maths     a suite a paper or folder, a case a statement or cell. A case fails where its verdict is not the
///           recorded one, in either direction; it is an error where the check failed or threw
/// Source    the schema of Jenkins' xUnit plugin
/// Result    the same bits on every run, apart from `time`, in seconds; system-out of a case has the verdict
///           and the evidence
[[nodiscard]] std::string report_junit(const Report& report);

}  // namespace radcert::verification
