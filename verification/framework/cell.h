// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "radcert/core/outcome.h"
#include "radcert/scalar/rational.h"
#include "verification/framework/verdict.h"

namespace radcert::verification {

/// A number as a table prints it.
/// Maths     value is the number; half_unit is half a unit of its last printed digit: "1.48E-3" is 0.00148
///           with 0.000005
/// Source    ours
/// Requires  made by parse_printed
/// Result    exact
/// Limits    says nothing of how the paper rounded: the half unit allows rounding to nearest alone
struct PrintedNumber {
  std::string text;
  Rational value;
  Rational half_unit;
};

/// A printed text as a number.
/// Maths     [-] digits [. digits] [(E|e) [+|-] digits]
/// Source    ours
/// Requires  nothing
/// Result    exact, or why the text is no printed number
/// Limits    at most 60 characters and exponents up to 300
[[nodiscard]] Outcome<PrintedNumber> parse_printed(std::string_view text);

/// What our value says of a printed number.
/// Maths     with o +- r ours, p printed and h its half unit:  |o-p| + r <= h  reproduced, certified if o +-
///           r is guaranteed; |o-p| - r > h  contradicted;  otherwise undecided
/// Source    verification/README.md
/// Requires  value finite, radius finite and >= 0, else ContractViolation
/// Result    the comparison is exact: no rounding can tip it
/// Limits    a radius that is an estimate makes the verdict one
[[nodiscard]] Verdict decide(const PrintedNumber& printed, double value, double radius, bool guaranteed);

}  // namespace radcert::verification
