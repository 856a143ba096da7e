// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/result.h"

namespace radcert {

/// A result of solve as JSON.
/// Source    the file format radcert/solution/1
/// Requires  figures are finite, else ContractViolation
/// Result    keys in the order of the format, null for what is absent, doubles in their shortest exact form;
///           `command` is how it was made. Apart from `timing` and `command` the same bits on every run
/// Limits    a ratio or an order that is not finite is null
JsonValue result_json(const Result& result, const std::string& command);

/// result_json as text, ending with a newline.
std::string result_text(const Result& result, const std::string& command);

/// Parts of it: an element of "levels", "orders", and an element of the levels of "timing".
JsonValue level_json(const LevelResult& level);
JsonValue orders_json(std::span<const OrderFit> orders);
JsonValue timing_json(const LevelTiming& timing);

}  // namespace radcert
