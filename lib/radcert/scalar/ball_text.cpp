// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <arb.h>
#include <flint/flint.h>
#include <optional>
#include <string>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_access.h"
#include "radcert/scalar/decimal.h"

namespace radcert {

namespace {

arb_ptr in(Ball& ball) { return static_cast<arb_ptr>(BallAccess::storage(ball)); }
arb_srcptr in(const Ball& ball) { return static_cast<arb_srcptr>(BallAccess::storage(ball)); }

using Integer = CValue<fmpz, fmpz_init, fmpz_clear>;

std::string text_of(const Integer& value) {
  char* letters = fmpz_get_str(nullptr, 10, value);
  std::string result(letters);
  flint_free(letters);
  return result;
}

BinaryNumber binary(arf_srcptr value) {
  Integer mantissa;
  Integer exponent;
  arf_get_fmpz_2exp(mantissa, exponent, value);
  return {text_of(mantissa), text_of(exponent)};
}

constexpr std::size_t longest_mantissa = 1000000;
/// An exponent with more digits would only exhaust the memory later.
constexpr std::size_t longest_exponent = 30;

/// Whether the text was an integer of moderate length, and its value.
bool read_integer(const std::string& text, std::size_t longest, fmpz* value) {
  const std::size_t start = !text.empty() && text.front() == '-' ? 1 : 0;
  const bool digits = text.size() > start && text.size() <= longest &&
                      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(),
                                  [](char letter) { return '0' <= letter && letter <= '9'; });
  return digits && fmpz_set_str(value, text.c_str(), 10) == 0;
}

std::optional<Ball> exact_ball(const BinaryNumber& number) {
  Integer mantissa;
  Integer exponent;
  if (!read_integer(number.mantissa, longest_mantissa, mantissa) ||
      !read_integer(number.exponent, longest_exponent, exponent))
    return std::nullopt;
  Ball result;
  arf_set_fmpz_2exp(arb_midref(in(result)), mantissa, exponent);
  return result;
}

/// A decimal or a fraction, enclosed at the current precision.
Outcome<Ball> number(std::string_view text) {
  if (text.find('/') != std::string_view::npos) {
    const Outcome<Rational> exact = Rational::parse(text);
    if (!exact) return because(exact.reason());
    return Ball(*exact);
  }
  if (!is_decimal(text)) return because("expected a decimal number or a fraction, found " + quotation(text));
  Ball result;
  if (arb_set_str(in(result), std::string(text).c_str(), BallPrecision::current()) != 0 ||
      arb_is_finite(in(result)) == 0) {
    return because("cannot enclose " + quotation(text));
  }
  return result;
}

/// How many digits of the midpoint mean something: two or three beyond the first place of the radius, so that
/// rounding the midpoint widens the ball by a small part.
slong meaningful_digits(arb_srcptr x, int most) {
  const double digits = static_cast<double>(arb_rel_accuracy_bits(x)) * 0.30103 + 4;
  return static_cast<slong>(std::clamp(digits, 1.0, static_cast<double>(most)));
}

std::string without_trailing_zeros(std::string text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t end = std::min(text.find('e'), text.size());
  std::size_t keep = text.find_last_not_of('0', end - 1);
  if (keep != point) ++keep;
  return text.erase(keep, end - keep);
}

}  // namespace

BallDecimal Ball::decimal(int digits) const {
  expects(is_finite(), "a finite ball", named("failure", failure()));
  expects(digits >= 1, "digits >= 1", named("digits", digits));
  // Arb writes "m", "[m +/- r]" or "[+/- r]".
  char* letters = arb_get_str(in(*this), meaningful_digits(in(*this), digits), ARB_STR_MORE);
  std::string text(letters);
  flint_free(letters);
  if (text.front() != '[') return {without_trailing_zeros(std::move(text)), "0"};
  const std::size_t sign = text.find("+/-");
  const std::string midpoint = text.substr(1, sign > 1 ? sign - 2 : 0);
  return {midpoint.empty() ? "0" : midpoint, text.substr(sign + 4, text.size() - sign - 5)};
}

std::string Ball::to_text(int digits) const {
  if (!is_finite()) return "unbounded: " + std::string(failure());
  const BallDecimal text = decimal(digits);
  return text.radius == "0" ? text.midpoint : text.midpoint + " +/- " + text.radius;
}

BinaryNumber Ball::midpoint_binary() const {
  expects(is_finite(), "a finite ball", named("failure", failure()));
  return binary(arb_midref(in(*this)));
}

BinaryNumber Ball::radius_binary() const {
  expects(is_finite(), "a finite ball", named("failure", failure()));
  return binary(arb_midref(in(radius_ball())));
}

Outcome<Ball> Ball::from_binary(const BinaryNumber& midpoint, const BinaryNumber& radius) {
  std::optional<Ball> result = exact_ball(midpoint);
  const std::optional<Ball> by = exact_ball(radius);
  if (!result) return because("the midpoint is not an integer times a power of two");
  if (!by || certainly_negative(*by))
    return because("the radius is not a natural number times a power of two");
  return widened(*result, *by);
}

Outcome<Ball> Ball::parse(std::string_view text) {
  if (text.size() >= 2 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
  constexpr std::string_view plus_minus = " +/- ";
  const std::size_t sign = text.find(plus_minus);
  Outcome<Ball> midpoint = number(text.substr(0, sign));
  if (!midpoint || sign == std::string_view::npos) return midpoint;
  const Outcome<Ball> radius = number(text.substr(sign + plus_minus.size()));
  if (!radius) return because("in the radius: " + radius.reason());
  if (certainly_negative(*radius)) return because("the radius is negative");
  return widened(*midpoint, *radius);
}

}  // namespace radcert
