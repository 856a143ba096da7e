// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/enclosure/demand.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::reference {

/// A parameter of a family of reference values.
struct ValueParameter {
  std::string name;
  std::string default_text;  ///< a decimal or a fraction
  std::string allowed;       ///< in words: "a number > 0"
  std::function<bool(const Rational&)> allows;
};

/// The values of the parameters, in their order.
using Arguments = std::vector<Rational>;

/// One way to a number, with a proof.
/// Maths     encloses the value in a ball whose radius is at most the one demanded
/// Source    `how` says it: a theorem, a catalogue number, a method
/// Requires  arguments that the parameters allow, 0 < radius
/// Result    the ball; or why it was not reached, and what was
/// Limits    most_digits: beyond 10^-most_digits the method is not asked
struct Route {
  std::string how;
  std::function<Outcome<Ball>(const Arguments&, const Rational& radius)> enclose;
  int most_digits = 1000;
};

/// A family of reference values: a formula with parameters, and two ways to its value.
/// Maths     the number that `formula` denotes
/// Source    `source`
/// Requires  the routes share no function above the layer `scalar`
/// Result    plain data
/// Limits    the names have only a-z, 0-9, _ and, in fractions, /
struct ValueFamily {
  std::string name;
  std::string summary;
  std::string formula;
  std::string source;
  std::vector<ValueParameter> parameters;
  Route route;
  Route second_route;
};

/// A value by its own name: a member of a family.
struct NamedValue {
  std::string name;
  std::string family;
  Arguments arguments;
};

/// The value that one route found.
struct RouteValue {
  std::string how;
  Ball value;
};

/// A reference value, enclosed twice.
/// Maths     value: by the first route, radius <= 10^-digits;  second: by the other one, radius <=
///           10^-min(digits, its most_digits)
/// Requires  made by enclose()
/// Result    the two balls overlap
struct EnclosedValue {
  int digits = 0;
  RouteValue first;
  RouteValue second;
};

/// All families, and all values that have a name of their own, in a fixed order.
[[nodiscard]] std::span<const ValueFamily> value_families();
[[nodiscard]] std::span<const NamedValue> named_values();

/// The family of that name, or null.
[[nodiscard]] const ValueFamily* find_family(std::string_view name);
/// The value of that name, or null.
[[nodiscard]] const NamedValue* find_value(std::string_view name);

/// The defaults of a family's parameters.
[[nodiscard]] Arguments default_arguments(const ValueFamily& family);

/// The most digits that may be asked for.
inline constexpr int most_reference_digits = 1000;

/// A member of a family by both of its routes.
/// Maths     see EnclosedValue
/// Requires  1 <= digits <= most_reference_digits + 1, one more than is shown, arguments that the parameters
///           allow, else ContractViolation
/// Result    the value, or why a route did not reach its radius
/// Limits    std::logic_error if the routes contradict each other: then one of them is wrong
[[nodiscard]] Outcome<EnclosedValue> enclose(const ValueFamily& family, const Arguments& arguments,
                                             int digits);

/// How many bits a number of the order of one has down to that radius; radius > 0.
[[nodiscard]] long bits_for(const Rational& radius);

/// A route through a formula in balls: evaluated with more and more bits.
/// Maths     f(arguments) at bits, 2 bits, ... until the radius is at most the one demanded
/// Requires  f makes its constants from the arguments at the precision current when it is called
/// Result    a route; it gives up at 64 times the bits that the radius itself has
[[nodiscard]] Route by_formula(std::string how, std::function<Ball(const Arguments&)> f);

/// A route through enclosed integrals.
/// Maths     integral(arguments, demand), at a precision that leaves the digits of the demand
/// Requires  integral makes its constants from the arguments at the precision current when it is called
/// Result    a route, asked for at most so many digits
/// Limits    a demand is a double: at most 300 digits
[[nodiscard]] Route by_integral(std::string how, int most_digits,
                                std::function<Enclosure(const Arguments&, const Demand&)> integral);

}  // namespace radcert::reference
