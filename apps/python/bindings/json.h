// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "python.h"
#include "radcert/formats/json/json_value.h"

namespace radcert::python {

/// What a file would have, from what Python has: dict, list, tuple, str, bool, None; ints and floats as
/// numbers, which mean doubles; exact numbers (Fraction, Decimal) and expressions as texts.
/// Result    InputError with the JSON pointer for everything else, for numbers that are not finite, for keys
///           that are no texts, and for what is nested more than 64 deep
[[nodiscard]] JsonValue json_of(const py::handle& object, const std::string& pointer = {});

/// The other way.
[[nodiscard]] py::object object_of(const JsonValue& value);

}  // namespace radcert::python
