// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/experiment.h"

namespace radcert {

/// The results of an experiment as JSON.
/// Source    the file format radcert/experiment_result/1
/// Requires  a result of collect for each combination, in their order; finite figures, else ContractViolation
/// Result    apart from `timing` and `command` the same bits on every run
/// Limits    as result_json
[[nodiscard]] JsonValue experiment_json(const Experiment& experiment, std::span<const Result> results,
                                        const std::string& command);

/// The levels of all combinations as CSV.
/// Source    RFC 4180
/// Requires  as experiment_json
/// Result    a row a combination and level: what the combination is, then the columns of errors_csv, fitted
///           orders last; no seconds, so that the same experiment gives the same bytes
/// Limits    what is null in the JSON file is empty here
[[nodiscard]] std::string experiment_errors_csv(const Experiment& experiment,
                                                std::span<const Result> results);

/// The seconds of all combinations as CSV, a row a combination and level.
[[nodiscard]] std::string experiment_timing_csv(const Experiment& experiment,
                                                std::span<const Result> results);

}  // namespace radcert
