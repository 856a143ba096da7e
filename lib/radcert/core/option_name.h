// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace radcert {

/// Where the options of a computation are written, which messages about them name.
enum class OptionStyle {
  command_line,  ///< "--two-sided"
  argument,      ///< "two_sided", of a function
};

/// The name of an option as its user writes it.
/// Requires  a name in lower case, its words joined by "-"
/// Result    with "--" in front, or with "_" in place of each "-"
[[nodiscard]] std::string option_name(OptionStyle style, std::string_view name);

}  // namespace radcert
