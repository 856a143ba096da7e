// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/continuous_means.h"

namespace radcert::app {

/// The means of a scene with what proves them, ready to be written.
/// Maths     reference::enclose; digits are those that the finer enclosure has
/// Result    by mean; AccuracyNotReached where a certificate does not hold
std::vector<ReferenceRecord> continuous_records(const reference::ContinuousScene& scene);

/// One of them.
ReferenceRecord continuous_record(const reference::ContinuousMean& mean);

/// The certificates of a scene as files of a folder.
std::vector<std::pair<std::filesystem::path, std::string>> certificate_files(
    const reference::ContinuousScene& scene, const std::filesystem::path& folder);

}  // namespace radcert::app
