// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/cell.h"

#include <charconv>
#include <cmath>

#include "radcert/core/text.h"
#include "radcert/scalar/real.h"

namespace radcert::verification {
namespace {

constexpr std::size_t longest = 60;
constexpr long largest_exponent = 300;

std::size_t digits_at(std::string_view text, std::size_t place) {
  std::size_t count = 0;
  while (place + count < text.size() && text[place + count] >= '0' && text[place + count] <= '9') ++count;
  return count;
}

}  // namespace

Outcome<PrintedNumber> parse_printed(std::string_view text) {
  const auto refused = [&](const char* why) {
    return because(quotation(text) + " is not a printed number: " + why);
  };
  if (text.size() > longest) return refused("it is too long");
  std::size_t place = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::size_t whole_digits = digits_at(text, place);
  if (whole_digits == 0) return refused("digits are expected");
  place += whole_digits;
  std::size_t fraction_digits = 0;
  if (place < text.size() && text[place] == '.') {
    fraction_digits = digits_at(text, ++place);
    if (fraction_digits == 0) return refused("digits are expected after the point");
    place += fraction_digits;
  }
  long exponent = 0;
  if (place < text.size() && (text[place] == 'E' || text[place] == 'e')) {
    ++place;
    const bool negative = place < text.size() && text[place] == '-';
    if (place < text.size() && (text[place] == '-' || text[place] == '+')) ++place;
    const std::size_t exponent_digits = digits_at(text, place);
    if (exponent_digits == 0) return refused("digits are expected in the exponent");
    const char* first = text.data() + place;
    if (std::from_chars(first, first + exponent_digits, exponent).ec != std::errc{} ||
        exponent > largest_exponent)
      return refused("its exponent is too large");
    if (negative) exponent = -exponent;
    place += exponent_digits;
  }
  if (place != text.size()) return refused("something follows the number");
  const Outcome<Rational> value = Rational::parse(text);
  if (!value) return because(value.reason());
  const Rational last_digit = power(Rational(10), exponent - static_cast<long>(fraction_digits));
  return PrintedNumber{.text = std::string(text), .value = *value, .half_unit = last_digit / Rational(2)};
}

Verdict decide(const PrintedNumber& printed, double value, double radius, bool guaranteed) {
  expects(std::isfinite(value), "a finite value", named("value", value), named("printed", printed.text));
  expects(std::isfinite(radius) && radius >= 0, "a finite radius >= 0", named("radius", radius));
  const Rational distance = abs(Rational::exactly(value) - printed.value);
  const Rational r = Rational::exactly(radius);
  if (distance + r <= printed.half_unit) return guaranteed ? Verdict::certified : Verdict::reproduced;
  if (distance - r > printed.half_unit) return Verdict::contradicted;
  return Verdict::undecided;
}

}  // namespace radcert::verification
