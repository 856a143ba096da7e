// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/reference/reference_value.h"

namespace radcert::reference::values {

/// Families of one theme, and those of their values that have names.
/// Source    each family names its own
/// Requires  the two routes of a family share no function above the layer `scalar`
/// Result    plain data; reference_value.cpp puts the themes below one after the other
struct Theme {
  std::vector<ValueFamily> families;
  std::vector<NamedValue> named;
};

/// The themes, each in the source of its name.
[[nodiscard]] Theme rectangle_factors();
[[nodiscard]] Theme round_factors();
[[nodiscard]] Theme point_factors();
[[nodiscard]] Theme two_squares();
[[nodiscard]] Theme operator_values();
[[nodiscard]] Theme interpolation();
[[nodiscard]] Theme exact_solutions();
[[nodiscard]] Theme edges();

/// A parameter > 0.
[[nodiscard]] ValueParameter positive(std::string name, std::string default_text);
/// A parameter of the open interval.
[[nodiscard]] ValueParameter strictly_between(std::string name, std::string default_text,
                                              const Rational& from, const Rational& to);
/// from <= value < to.
[[nodiscard]] ValueParameter from_to_below(std::string name, std::string default_text, const Rational& from,
                                           const Rational& to);
/// A whole number, from <= value <= to.
[[nodiscard]] ValueParameter whole(std::string name, std::string default_text, long from, long to);
[[nodiscard]] ValueParameter any_number(std::string name, std::string default_text);

}  // namespace radcert::reference::values
