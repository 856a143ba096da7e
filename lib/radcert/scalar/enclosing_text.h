// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/scalar/rational.h"

namespace radcert {

/// How a number is laid out in decimal.
/// Maths     scientific: d digits, "1.4836e-03"; general: at most d digits without trailing zeros, "0.8",
///           "2.5e-7", an exponent only where the number is below 10^-4 or has more than d digits before the
///           point; padded: the same with all d digits, "0.800"; fixed: k digits after the point, "3.94"
/// Source    printf's %e, %g and %f; general does not pad its exponent
/// Requires  scientific, general, padded: 1 <= digits <= 100; fixed: 0 <= decimals <= 100, else
///           ContractViolation
/// Result    plain data
class DecimalForm {
public:
  enum class Kind { scientific, general, padded, fixed };
  [[nodiscard]] static DecimalForm scientific(int digits);
  [[nodiscard]] static DecimalForm general(int digits);
  [[nodiscard]] static DecimalForm padded(int digits);
  [[nodiscard]] static DecimalForm fixed(int decimals);
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] int digits() const { return digits_; }

private:
  DecimalForm(Kind kind, int digits) : kind_(kind), digits_(digits) {}
  Kind kind_;
  int digits_;
};

/// A midpoint and a radius as two decimals.
struct EnclosingText {
  std::string value;
  std::string radius;
};

/// A number with its radius in decimal, rounded outwards: the one way in which such a pair is printed.
/// Maths     t the midpoint's text, s the radius' text, both read as decimal numbers: |value - t| + radius <=
///           s, so that [value - radius, value + radius] lies in [t - s, t + s]
/// Requires  a finite value; radius >= 0, else ContractViolation
/// Result    value: rounded to nearest, ties to even, in the form. radius: the least decimal of two
///           significant digits, or with fixed of so many decimals, that is not below the sum on the left;
///           "0" where that is zero, "inf" for an infinite radius. Proof: the midpoint is rounded first, in
///           whole numbers; what that left out is a rational number, exactly known, and the rounding up of
///           its sum with the radius compares whole numbers. No step is done in floating point
/// Limits    an exact value shows a radius where its digits were rounded. A double printed with fewer than
///           its digits, or in the shortest text that reads back as it (core/text.h), is a rounding of that
///           double: such a text encloses nothing
[[nodiscard]] EnclosingText enclosing_text(const Rational& value, const Rational& radius, DecimalForm form);
[[nodiscard]] EnclosingText enclosing_text(double value, double radius, DecimalForm form);

/// The same as one word, the radius in units of the last digit of the midpoint, as papers and siunitx have
/// it.
/// Maths     "1.4836(21)e-3" is 1.4836e-3 +- 0.0021e-3, which contains [value - radius, value + radius]
/// Requires  a finite value, a finite radius >= 0; 1 <= digits <= 100, else ContractViolation
/// Result    so many digits of the midpoint, and as many fewer as leave the radius at most two digits; one
///           digit at least, or 0 where the radius is so much larger. Without parentheses where the text is
///           exactly the number
[[nodiscard]] std::string parenthesised_text(double value, double radius, int digits);
[[nodiscard]] std::string parenthesised_text(const Rational& value, const Rational& radius, int digits);

/// A bound from above in decimal, and one from below.
/// Maths     bound <= upper_text(bound), lower_text(bound) <= bound, both texts read as decimal numbers
/// Result    the nearest such decimal in the form, without one as radii are printed: two digits, an exponent
///           unless the first of them stands beside the point; "inf", "-inf" for what is infinite. A NaN
///           bounds nothing: "inf", "-inf"
[[nodiscard]] std::string upper_text(double bound);
[[nodiscard]] std::string upper_text(const Rational& bound);
[[nodiscard]] std::string upper_text(double bound, DecimalForm form);
[[nodiscard]] std::string upper_text(const Rational& bound, DecimalForm form);
[[nodiscard]] std::string lower_text(double bound, DecimalForm form);

/// A bound from above that is below 1, with as many digits as show that.
/// Result    upper_text with general form and `digits` digits, or as many more as it takes for the text to be
///           below 1
[[nodiscard]] std::string upper_text_below_one(double bound, int digits);

/// A number of which no error is known, rounded to nearest, ties to even: no enclosure.
/// Result    "inf", "-inf", "nan" for what is not finite
[[nodiscard]] std::string nearest_text(double value, DecimalForm form);
[[nodiscard]] std::string nearest_text(const Rational& value, DecimalForm form);

}  // namespace radcert
