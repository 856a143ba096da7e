// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

/// Adds a value and its radius to a row of a table.
/// Result    two cells; the radius counts the digits that are not printed. "-" for what is absent or not
///           finite, and for a radius that is not known
void push(std::vector<std::string>& row, const std::optional<Approximation>& number,
          DecimalForm form = DecimalForm::scientific(5));

}  // namespace radcert::app
