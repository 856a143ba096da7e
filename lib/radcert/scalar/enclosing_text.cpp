// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/enclosing_text.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {

namespace {

constexpr int most_digits = 100;

enum class Rounding { nearest, towards_zero, away_from_zero };

/// sign digits 10^exponent; the digits are a natural number without leading zeros, "0" for zero.
struct Decimal {
  bool negative = false;
  std::string digits = "0";
  long exponent = 0;

  [[nodiscard]] bool is_zero() const { return digits == "0"; }
  /// Of the first digit.
  [[nodiscard]] long leading() const { return exponent + static_cast<long>(digits.size()) - 1; }
  [[nodiscard]] Rational value() const {
    CValue<__mpq_struct, mpq_init, mpq_clear> whole;
    mpz_set_str(mpq_numref(whole), digits.c_str(), 10);
    const Rational size = Rational::from_gmp(whole) * power(Rational(10), exponent);
    return negative ? -size : size;
  }
};

using Natural = CValue<__mpz_struct, mpz_init, mpz_clear>;

/// |q| 10^places as a whole number.
void whole_part(mpz_ptr result, const Rational& q, long places, Rounding rounding) {
  const auto* fraction = static_cast<mpq_srcptr>(q.gmp());
  Natural up;
  Natural down;
  Natural ten;
  mpz_abs(up, mpq_numref(fraction));
  mpz_set(down, mpq_denref(fraction));
  mpz_ui_pow_ui(ten, 10, static_cast<unsigned long>(std::labs(places)));
  mpz_ptr scaled = places >= 0 ? mpz_ptr(up) : mpz_ptr(down);
  mpz_mul(scaled, scaled, ten);
  Natural rest;
  mpz_fdiv_qr(result, rest, up, down);
  if (mpz_sgn(static_cast<mpz_srcptr>(rest)) == 0 || rounding == Rounding::towards_zero) return;
  if (rounding == Rounding::nearest) {
    mpz_mul_2exp(rest, rest, 1);
    const int half = mpz_cmp(rest, down);
    if (half < 0 || (half == 0 && mpz_even_p(result) != 0)) return;
  }
  mpz_add_ui(result, result, 1);
}

std::string text_of(mpz_srcptr whole) {
  std::string digits(mpz_sizeinbase(whole, 10) + 2, '\0');
  mpz_get_str(digits.data(), 10, whole);
  digits.resize(digits.find('\0'));
  return digits;
}

/// With so many decimals.
Decimal with_decimals(const Rational& q, long decimals, Rounding rounding) {
  Natural whole;
  whole_part(whole, q, decimals, rounding);
  return {.negative = q.sign() < 0, .digits = text_of(whole), .exponent = -decimals};
}

/// With so many significant digits.
Decimal with_digits(const Rational& q, int digits, Rounding rounding) {
  if (q.sign() == 0) return {};
  // The power of ten of the first digit: the lengths of numerator and denominator tell it to one or two, the
  // digits tell the rest.
  const auto* fraction = static_cast<mpq_srcptr>(q.gmp());
  long leading = static_cast<long>(mpz_sizeinbase(mpq_numref(fraction), 10)) -
                 static_cast<long>(mpz_sizeinbase(mpq_denref(fraction), 10));
  for (;;) {
    const Decimal cut = with_decimals(q, digits - 1 - leading, Rounding::towards_zero);
    if (cut.is_zero()) {
      leading -= 2;
      continue;
    }
    const long found = cut.leading();
    if (found == leading) break;
    leading = found;
  }
  Decimal rounded = with_decimals(q, digits - 1 - leading, rounding);
  // 9.99 rounded to 10.0.
  if (rounded.digits.size() > static_cast<std::size_t>(digits)) {
    rounded.digits.pop_back();
    ++rounded.exponent;
  }
  return rounded;
}

Decimal rounded(const Rational& q, DecimalForm form, Rounding rounding) {
  return form.kind() == DecimalForm::Kind::fixed ? with_decimals(q, form.digits(), rounding)
                                                 : with_digits(q, form.digits(), rounding);
}

/// The digits with a point that has `decimals` of them behind it.
std::string plain(std::string digits, long decimals) {
  if (decimals <= 0)
    return digits + (digits == "0" ? "" : std::string(static_cast<std::size_t>(-decimals), '0'));
  const auto behind = static_cast<std::size_t>(decimals);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  return digits.insert(digits.size() - behind, ".");
}

std::string mantissa(const std::string& digits) {
  return digits.size() == 1 ? digits : digits.substr(0, 1) + "." + digits.substr(1);
}

std::string without_trailing_zeros(std::string digits) {
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

std::string scientific_text(const Decimal& decimal, int digits) {
  if (decimal.is_zero()) return mantissa(std::string(static_cast<std::size_t>(digits), '0')) + "e+00";
  std::string power = std::to_string(std::labs(decimal.leading()));
  if (power.size() < 2) power.insert(0, "0");
  return mantissa(decimal.digits) + (decimal.leading() < 0 ? "e-" : "e+") + power;
}

/// An exponent where the first digit stands at 10^power with power outside [least, largest].
std::string general_text(const Decimal& decimal, long least, long largest, bool all_digits = false) {
  if (decimal.is_zero()) return "0";
  const std::string digits = all_digits ? decimal.digits : without_trailing_zeros(decimal.digits);
  const long leading = decimal.leading();
  if (leading < least || leading > largest) return mantissa(digits) + "e" + std::to_string(leading);
  return plain(digits, static_cast<long>(digits.size()) - 1 - leading);
}

std::string text(const Decimal& decimal, DecimalForm form) {
  constexpr long least_plain = -4;
  std::string size;
  switch (form.kind()) {
    case DecimalForm::Kind::scientific: size = scientific_text(decimal, form.digits()); break;
    case DecimalForm::Kind::general: size = general_text(decimal, least_plain, form.digits() - 1); break;
    case DecimalForm::Kind::padded: size = general_text(decimal, least_plain, form.digits() - 1, true); break;
    case DecimalForm::Kind::fixed: size = plain(decimal.digits, form.digits()); break;
  }
  return (decimal.negative && !decimal.is_zero() ? "-" : "") + size;
}

/// Upwards or downwards as a number, whatever its sign.
std::string directed(const Rational& q, DecimalForm form, bool upwards) {
  const Rounding rounding = (q.sign() >= 0) == upwards ? Rounding::away_from_zero : Rounding::towards_zero;
  return text(rounded(q, form, rounding), form);
}

std::string directed(double bound, DecimalForm form, bool upwards) {
  if (std::isfinite(bound)) return directed(Rational::exactly(bound), form, upwards);
  const bool is_large = std::isnan(bound) ? upwards : bound > 0;
  return is_large ? "inf" : "-inf";
}

std::string radius_text(const Rational& radius, DecimalForm form) {
  const bool is_fixed = form.kind() == DecimalForm::Kind::fixed && radius.sign() != 0;
  return is_fixed ? upper_text(radius, form) : upper_text(radius);
}

}  // namespace

DecimalForm DecimalForm::scientific(int digits) {
  expects(1 <= digits && digits <= most_digits, "1 to 100 digits", named("digits", digits));
  return {Kind::scientific, digits};
}

DecimalForm DecimalForm::general(int digits) {
  expects(1 <= digits && digits <= most_digits, "1 to 100 digits", named("digits", digits));
  return {Kind::general, digits};
}

DecimalForm DecimalForm::padded(int digits) {
  expects(1 <= digits && digits <= most_digits, "1 to 100 digits", named("digits", digits));
  return {Kind::padded, digits};
}

DecimalForm DecimalForm::fixed(int decimals) {
  expects(0 <= decimals && decimals <= most_digits, "0 to 100 decimals", named("decimals", decimals));
  return {Kind::fixed, decimals};
}

EnclosingText enclosing_text(const Rational& value, const Rational& radius, DecimalForm form) {
  expects(radius.sign() >= 0, "radius >= 0", named("radius", radius));
  const Decimal shown = rounded(value, form, Rounding::nearest);
  return {.value = text(shown, form), .radius = radius_text(abs(value - shown.value()) + radius, form)};
}

EnclosingText enclosing_text(double value, double radius, DecimalForm form) {
  expects(std::isfinite(value), "a finite value", named("value", value));
  expects(radius >= 0, "radius >= 0", named("radius", radius));
  if (std::isinf(radius)) return {.value = nearest_text(value, form), .radius = "inf"};
  return enclosing_text(Rational::exactly(value), Rational::exactly(radius), form);
}

std::string parenthesised_text(double value, double radius, int digits) {
  expects(std::isfinite(value), "a finite value", named("value", value));
  expects(std::isfinite(radius) && radius >= 0, "a finite radius >= 0", named("radius", radius));
  return parenthesised_text(Rational::exactly(value), Rational::exactly(radius), digits);
}

std::string parenthesised_text(const Rational& x, const Rational& r, int digits) {
  expects(r.sign() >= 0, "radius >= 0", named("radius", r));
  expects(1 <= digits && digits <= most_digits, "1 to 100 digits", named("digits", digits));
  constexpr std::size_t most_of_radius = 2;
  Decimal shown = with_digits(x, digits, Rounding::nearest);
  if (shown.is_zero()) {
    // The unit is that of the radius' second digit.
    if (r.sign() == 0) return "0";
    shown.exponent = with_digits(r, 2, Rounding::away_from_zero).exponent;
  }
  Decimal units;
  for (;;) {
    units = with_decimals(abs(x - shown.value()) + r, -shown.exponent, Rounding::away_from_zero);
    if (units.digits.size() <= most_of_radius) break;
    // As many digits fewer as the radius has too many, down to none.
    const auto fewer = static_cast<long>(units.digits.size() - most_of_radius);
    shown = with_decimals(x, -(shown.exponent + fewer), Rounding::nearest);
  }
  const std::string around = units.is_zero() ? "" : "(" + units.digits + ")";
  const std::string sign = shown.negative && !shown.is_zero() ? "-" : "";
  const long power = shown.is_zero() ? shown.exponent : shown.leading();
  return sign + mantissa(shown.digits) + around + (power == 0 ? "" : "e" + std::to_string(power));
}

std::string upper_text(const Rational& bound) {
  constexpr int digits = 2;
  const Rounding rounding = bound.sign() >= 0 ? Rounding::away_from_zero : Rounding::towards_zero;
  return (bound.sign() < 0 ? "-" : "") + general_text(with_digits(bound, digits, rounding), -1, 1);
}

std::string upper_text(double bound) {
  return std::isfinite(bound) ? upper_text(Rational::exactly(bound)) : bound < 0 ? "-inf" : "inf";
}

std::string upper_text(double bound, DecimalForm form) { return directed(bound, form, true); }

std::string upper_text(const Rational& bound, DecimalForm form) { return directed(bound, form, true); }

std::string lower_text(double bound, DecimalForm form) { return directed(bound, form, false); }

std::string upper_text_below_one(double bound, int digits) {
  expects(bound < 1, "a bound below 1", named("bound", bound));
  for (;; ++digits) {
    // A double below 1 is at most 1 - 2^-53: 17 digits are enough.
    std::string shown = upper_text(bound, DecimalForm::general(digits));
    if (shown != "1") return shown;
  }
}

std::string nearest_text(double value, DecimalForm form) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return nearest_text(Rational::exactly(value), form);
}

std::string nearest_text(const Rational& value, DecimalForm form) {
  return text(rounded(value, form, Rounding::nearest), form);
}

}  // namespace radcert
