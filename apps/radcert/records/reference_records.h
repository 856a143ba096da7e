// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/option_name.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/reference_value.h"

namespace radcert::app {

/// The value of a parameter as its user gave it: a decimal or a fraction.
struct Setting {
  std::string name;
  std::string value;
};

/// Puts the settings into the arguments of a family.
/// Result    InputError for a name that is no parameter or comes twice, and for a value that is not allowed:
///           at --set on a command line, at the parameter's own name elsewhere
void apply(std::span<const Setting> settings, std::string_view family,
           std::span<const reference::ValueParameter> parameters, reference::Arguments& arguments,
           OptionStyle style);

/// A member of a family, with the name under which it was asked for.
struct WantedReference {
  std::string name;
  const reference::ValueFamily* family = nullptr;
  reference::Arguments arguments;
};

/// The value of a name of its own.
[[nodiscard]] WantedReference member(const reference::NamedValue& value);

/// What a name and settings stand for: a value of that name, or a member of the family.
/// Result    InputError for settings of what is one value, and for a name that is unknown, with the nearest
[[nodiscard]] WantedReference wanted_reference(const std::string& name, std::span<const Setting> settings,
                                               OptionStyle style);

/// All names that `radcert reference` knows.
[[nodiscard]] std::vector<std::string> reference_names();

/// A record of what routes have found.
[[nodiscard]] ReferenceRecord record_with(const WantedReference& wanted, int digits,
                                          std::vector<ReferenceRoute> routes);

/// Both routes, at work now.
/// Requires  1 <= digits <= most_reference_digits
/// Result    AccuracyNotReached where a route does not reach 10^-digits
[[nodiscard]] ReferenceRecord record_of(const WantedReference& wanted, int digits);

}  // namespace radcert::app
