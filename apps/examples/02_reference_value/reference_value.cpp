// SPDX-License-Identifier: GPL-3.0-or-later

// A reference value from C++: what part of the light that leaves a unit square arrives at the one that meets
// it at an angle of 2/7 of a half turn, in a ball that is proved to hold it.
#include <exception>
#include <iostream>

#include "radcert/reference/reference_value.h"

int main() try {
  using namespace radcert;
  const reference::ValueFamily& family = *reference::find_family("inclined_rectangles");

  // Parameters are exact. Those that are not set keep their defaults: edge, from_width and to_width are 1.
  reference::Arguments arguments = reference::default_arguments(family);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (family.parameters[i].name == "half_turns") arguments[i] = Rational(2, 7);

  constexpr int digits = 30;
  const Outcome<reference::EnclosedValue> value = reference::enclose(family, arguments, digits);
  if (!value) {
    std::cerr << value.reason() << '\n';
    return 1;
  }
  for (const reference::RouteValue& route : {value->first, value->second}) {
    const BallDecimal text = route.value.decimal(digits);
    std::cout << text.midpoint << " +- " << text.radius << "  " << route.how << '\n';
  }

  // A ball compares with a proof: both answers may be no.
  const Ball printed(Rational(4326, 10000));
  std::cout << "below 0.4326: " << certainly_less(value->first.value, printed)
            << ", above: " << certainly_less(printed, value->first.value) << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
