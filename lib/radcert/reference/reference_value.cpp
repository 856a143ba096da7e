// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/reference_value.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/reference/values/families.h"
#include "radcert/scalar/raised_precision.h"

namespace radcert::reference {
namespace {

const WorkLimit precision_of_formulas("reference/reference_value: bits of a formula for each bit wanted", 64,
                                      1, "refused, with the ball reached");

Rational power_of_ten(int exponent) { return power(Rational(10), exponent); }

std::string as_text(const Arguments& arguments) {
  std::string text;
  for (const Rational& argument : arguments) text += (text.empty() ? "" : ", ") + argument.to_text();
  return "(" + text + ")";
}

Outcome<RouteValue> along(const Route& route, const Arguments& arguments, int digits) {
  const Outcome<Ball> value = route.enclose(arguments, power_of_ten(-digits));
  if (!value) return because(route.how + ": " + value.reason());
  return RouteValue{.how = route.how, .value = *value};
}

/// All themes, one after the other.
const values::Theme& everything() {
  static const values::Theme all = [] {
    values::Theme sum;
    for (const auto theme :
         {values::rectangle_factors, values::round_factors, values::point_factors, values::two_squares,
          values::operator_values, values::interpolation, values::exact_solutions, values::edges}) {
      values::Theme part = theme();
      std::move(part.families.begin(), part.families.end(), std::back_inserter(sum.families));
      std::move(part.named.begin(), part.named.end(), std::back_inserter(sum.named));
    }
    return sum;
  }();
  return all;
}

}  // namespace

std::span<const ValueFamily> value_families() { return everything().families; }

std::span<const NamedValue> named_values() { return everything().named; }

const ValueFamily* find_family(std::string_view name) {
  const auto families = value_families();
  const auto found = std::find_if(families.begin(), families.end(),
                                  [name](const ValueFamily& family) { return family.name == name; });
  return found == families.end() ? nullptr : &*found;
}

const NamedValue* find_value(std::string_view name) {
  const auto named = named_values();
  const auto found = std::find_if(named.begin(), named.end(),
                                  [name](const NamedValue& value) { return value.name == name; });
  return found == named.end() ? nullptr : &*found;
}

Arguments default_arguments(const ValueFamily& family) {
  Arguments arguments;
  for (const ValueParameter& parameter : family.parameters)
    arguments.push_back(Rational::parse(parameter.default_text).value());
  return arguments;
}

Outcome<EnclosedValue> enclose(const ValueFamily& family, const Arguments& arguments, int digits) {
  expects(1 <= digits && digits <= most_reference_digits + 1, "1 <= digits <= 1001", named("digits", digits));
  expects(arguments.size() == family.parameters.size(), "a value for each parameter",
          named("values", arguments.size()), named("family", family.name));
  for (std::size_t i = 0; i < arguments.size(); ++i)
    expects(family.parameters[i].allows(arguments[i]), family.parameters[i].allowed,
            named(family.parameters[i].name, arguments[i]), named("family", family.name));
  // One digit more is what a value needs that is to be rounded.
  if (digits > family.route.most_digits + 1)
    return because(family.route.how + ": gives at most " + std::to_string(family.route.most_digits) +
                   " digits");
  Outcome<RouteValue> first = along(family.route, arguments, digits);
  if (!first) return because(first.reason());
  Outcome<RouteValue> second =
      along(family.second_route, arguments, std::min(digits, family.second_route.most_digits));
  if (!second) return because(second.reason());
  if (!overlaps(first->value, second->value))
    throw std::logic_error(family.name + as_text(arguments) +
                           ": two proofs contradict each other: " + first->value.to_text(40) + " (" +
                           first->how + "), " + second->value.to_text(40) + " (" + second->how + ")");
  return EnclosedValue{.digits = digits, .first = *std::move(first), .second = *std::move(second)};
}

long bits_for(const Rational& radius) {
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  long bits = 0;
  for (Rational unit = 1; unit > radius; unit = unit / Rational(2)) ++bits;
  return bits;
}

Route by_formula(std::string how, std::function<Ball(const Arguments&)> f) {
  Route route;
  route.how = std::move(how);
  route.enclose = [f = std::move(f)](const Arguments& arguments, const Rational& radius) {
    const long wanted = bits_for(radius);
    return at_raised_precision(
        wanted + 32, precision_of_formulas.value() * (wanted + 32), [&] { return f(arguments); },
        [&radius](const Ball& value) { return certainly_at_most(value.radius_ball(), Ball(radius)); });
  };
  return route;
}

Route by_integral(std::string how, int most_digits,
                  std::function<Enclosure(const Arguments&, const Demand&)> integral) {
  expects(1 <= most_digits && most_digits <= 300, "1 <= most_digits <= 300",
          named("most_digits", most_digits));
  Route route;
  route.how = std::move(how);
  route.most_digits = most_digits;
  route.enclose = [integral = std::move(integral)](const Arguments& arguments,
                                                   const Rational& radius) -> Outcome<Ball> {
    const BallPrecision precision(bits_for(radius) + 64);
    // Rounded down by a little: the radius that comes out is to be below the fraction that was demanded.
    const Enclosure enclosure = integral(arguments, {.radius = radius.to_double() * (1 - 0x1p-40)});
    if (!enclosure) return because(enclosure.reason().to_text());
    return enclosure->value;
  };
  return route;
}

}  // namespace radcert::reference
