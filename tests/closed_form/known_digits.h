// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "radcert/scalar/ball.h"

namespace radcert {

/// Whether a ball has a radius of at most 1e-30 and meets a decimal to within a unit of its last place.
inline testing::AssertionResult has_digits(const Ball& value, std::string_view digits) {
  const std::size_t places = digits.size() - 1 - digits.find('.');
  const Rational known = Rational::parse(digits).value();
  const Ball widely = widened(Ball(known), Ball(power(Rational(1, 10), static_cast<long>(places))));
  if (value.is_finite() && value.radius() <= 1e-30 && overlaps(value, widely))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << value.to_text(40) << " and not " << digits;
}

/// Whether two balls overlap, both with a radius of at most `radius`.
inline testing::AssertionResult same_number(const Ball& a, const Ball& b, double radius) {
  if (a.is_finite() && b.is_finite() && a.radius() <= radius && b.radius() <= radius && overlaps(a, b))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << a.to_text(40) << " and " << b.to_text(40);
}

}  // namespace radcert
