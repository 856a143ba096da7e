// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "radcert/formats/json/json_value.h"

namespace radcert {

/// A list that stands in the library, as a schema needs it.
/// Source    the surfaces of the catalogue and the words that the readers of problem files take
/// Requires  a name that a gap of a schema may have, as "surfaces", else ContractViolation
/// Result    an array of words; for "parameters of surfaces" an array of conditional schemas, one for all
///           surfaces that take the same parameters
JsonValue catalogue_json(std::string_view name);

}  // namespace radcert
