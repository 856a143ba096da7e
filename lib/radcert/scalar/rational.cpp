// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/rational.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <gmp.h>
#include <new>
#include <system_error>
#include <vector>

#include "radcert/core/c_value.h"

namespace radcert {

namespace {

constexpr std::size_t longest_text = 1000;
constexpr long largest_exponent = 400;

mpq_ptr in(std::byte* storage) { return std::launder(reinterpret_cast<mpq_ptr>(storage)); }

mpq_srcptr in(const Rational& value) { return static_cast<mpq_srcptr>(value.gmp()); }

using Integer = CValue<__mpz_struct, mpz_init, mpz_clear>;

std::string text_of(mpz_srcptr value) {
  std::vector<char> digits(mpz_sizeinbase(value, 10) + 2);
  return mpz_get_str(digits.data(), 10, value);
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// A decimal as digits * 10^exponent.
struct Decimal {
  std::string digits;
  long exponent = 0;
};

Outcome<Decimal> parse_decimal(std::string_view text) {
  Decimal decimal;
  std::size_t at = 0;
  const auto take_digits = [&] {
    const std::size_t start = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    decimal.digits.append(text.substr(start, at - start));
    return static_cast<long>(at - start);
  };
  take_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    decimal.exponent = -take_digits();
  }
  if (decimal.digits.empty()) return because("expected a digit");
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const bool plus = at < text.size() && text[at] == '+';
    if (plus) ++at;
    if (plus && at < text.size() && text[at] == '-') return because("the exponent has two signs");
    long exponent = 0;
    const auto read = std::from_chars(text.data() + at, text.data() + text.size(), exponent);
    if (read.ec == std::errc::invalid_argument) return because("expected the digits of the exponent");
    if (read.ec != std::errc() || exponent > largest_exponent || exponent < -largest_exponent) {
      return because("the exponent is beyond " + std::to_string(largest_exponent));
    }
    at = static_cast<std::size_t>(read.ptr - text.data());
    decimal.exponent += exponent;
  }
  if (at != text.size()) return because("unexpected " + quotation(text.substr(at)));
  return decimal;
}

/// result := result * decimal, or result / decimal for sign = -1; numerator and denominator are not reduced.
void scale_by(mpq_ptr result, const Decimal& decimal, bool inverse) {
  Integer digits;
  mpz_set_str(digits, decimal.digits.c_str(), 10);
  Integer ten;
  mpz_ui_pow_ui(ten, 10, static_cast<unsigned long>(std::abs(decimal.exponent)));
  mpz_ptr up = mpq_numref(result);
  mpz_ptr down = mpq_denref(result);
  if (inverse) std::swap(up, down);
  mpz_mul(up, up, digits);
  mpz_ptr ten_goes_to = decimal.exponent >= 0 ? up : down;
  mpz_mul(ten_goes_to, ten_goes_to, ten);
}

}  // namespace

static_assert(sizeof(mpq_t) == 32 && alignof(mpq_t) <= 8, "the storage in the header holds an mpq_t");

Rational::Rational() noexcept { mpq_init(new (storage_) __mpq_struct); }

Rational::Rational(long numerator, long denominator) : Rational() {
  expects(denominator != 0, "a denominator other than zero", named("numerator", numerator),
          named("denominator", denominator));
  mpz_set_si(mpq_numref(in(storage_)), numerator);
  mpz_set_si(mpq_denref(in(storage_)), denominator);
  mpq_canonicalize(in(storage_));
}

Rational::Rational(const Rational& other) : Rational() { mpq_set(in(storage_), in(other)); }

Rational::Rational(Rational&& other) noexcept : Rational() { exchange(other); }

Rational& Rational::operator=(const Rational& other) {
  mpq_set(in(storage_), in(other));
  return *this;
}

Rational& Rational::operator=(Rational&& other) noexcept {
  exchange(other);
  return *this;
}

Rational::~Rational() { mpq_clear(in(storage_)); }

void Rational::set_signed(long value) { mpq_set_si(in(storage_), value, 1); }

void Rational::set_unsigned(unsigned long value) { mpq_set_ui(in(storage_), value, 1); }

Rational Rational::exactly(double value) {
  expects(std::isfinite(value), "a finite double", named("value", value));
  Rational result;
  mpq_set_d(in(result.storage_), value);
  return result;
}

Rational Rational::from_gmp(const void* mpq) {
  Rational result;
  mpq_set(in(result.storage_), static_cast<mpq_srcptr>(mpq));
  return result;
}

Outcome<Rational> Rational::parse(std::string_view text) {
  if (text.size() > longest_text) return because("more than " + std::to_string(longest_text) + " characters");
  if (text.empty()) return because("expected a number, found nothing");
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  const std::size_t stroke = text.find('/');
  const Outcome<Decimal> above = parse_decimal(text.substr(0, stroke));
  if (!above) return because(above.reason());

  Rational result(1);
  mpq_ptr value = in(result.storage_);
  scale_by(value, *above, false);
  if (stroke != std::string_view::npos) {
    const Outcome<Decimal> below = parse_decimal(text.substr(stroke + 1));
    if (!below) return because("in the denominator: " + below.reason());
    scale_by(value, *below, true);
    if (mpz_sgn(mpq_denref(value)) == 0) return because("the denominator is zero");
  }
  mpq_canonicalize(value);
  if (negative) mpq_neg(value, value);
  return result;
}

Rational& Rational::operator+=(const Rational& other) {
  mpq_add(in(storage_), in(storage_), in(other));
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  mpq_sub(in(storage_), in(storage_), in(other));
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  mpq_mul(in(storage_), in(storage_), in(other));
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  expects(other.sign() != 0, "a divisor other than zero", named("dividend", *this));
  mpq_div(in(storage_), in(storage_), in(other));
  return *this;
}

Rational Rational::operator-() const {
  Rational result(*this);
  mpq_neg(in(result.storage_), in(result.storage_));
  return result;
}

int Rational::sign() const { return mpq_sgn(in(*this)); }

bool Rational::is_integer() const { return mpz_cmp_ui(mpq_denref(in(*this)), 1) == 0; }

Rational Rational::numerator() const {
  Rational result;
  mpz_set(mpq_numref(in(result.storage_)), mpq_numref(in(*this)));
  return result;
}

Rational Rational::denominator() const {
  Rational result;
  mpz_set(mpq_numref(in(result.storage_)), mpq_denref(in(*this)));
  return result;
}

std::optional<long> Rational::to_long() const {
  if (!is_integer() || mpz_fits_slong_p(mpq_numref(in(*this))) == 0) return std::nullopt;
  return mpz_get_si(mpq_numref(in(*this)));
}

double Rational::to_double() const {
  mpz_srcptr numerator = mpq_numref(in(*this));
  mpz_srcptr denominator = mpq_denref(in(*this));
  const int signum = sign();
  if (signum == 0) return 0.0;

  Integer n;
  Integer d;
  mpz_abs(n, numerator);
  mpz_set(d, denominator);
  // 2^p <= n/d < 2^(p+1)
  const auto bits = [](mpz_srcptr z) { return static_cast<std::int64_t>(mpz_sizeinbase(z, 2)); };
  std::int64_t p = bits(n) - bits(d);
  if (p > 1025) return signum * HUGE_VAL;
  if (p < -1080) return signum * 0.0;
  {
    Integer scaled;
    const auto shift = static_cast<mp_bitcnt_t>(p >= 0 ? p : -p);
    mpz_mul_2exp(scaled, p >= 0 ? mpz_srcptr(d) : mpz_srcptr(n), shift);
    const bool below = p >= 0 ? mpz_cmp(n, scaled) < 0 : mpz_cmp(scaled, d) < 0;
    if (below) --p;
  }
  // The last place of the result is 2^k; q = n / (d 2^k) rounded to an integer of at most 53 bits, or 2^53.
  const std::int64_t k = std::max<std::int64_t>(p - 52, -1074);
  if (k >= 0) {
    mpz_mul_2exp(d, d, static_cast<mp_bitcnt_t>(k));
  } else {
    mpz_mul_2exp(n, n, static_cast<mp_bitcnt_t>(-k));
  }
  Integer q;
  Integer rest;
  mpz_fdiv_qr(q, rest, n, d);
  mpz_mul_2exp(rest, rest, 1);
  const int half = mpz_cmp(rest, d);
  if (half > 0 || (half == 0 && mpz_odd_p(static_cast<mpz_srcptr>(q)) != 0)) mpz_add_ui(q, q, 1);
  return signum * std::ldexp(mpz_get_d(q), static_cast<int>(k));
}

std::string Rational::to_text() const {
  return is_integer() ? numerator_text() : numerator_text() + "/" + denominator_text();
}

std::string Rational::numerator_text() const { return text_of(mpq_numref(in(*this))); }

std::string Rational::denominator_text() const { return text_of(mpq_denref(in(*this))); }

bool Rational::equals(const Rational& other) const { return mpq_equal(in(*this), in(other)) != 0; }

std::strong_ordering Rational::compare(const Rational& other) const {
  return mpq_cmp(in(*this), in(other)) <=> 0;
}

void Rational::exchange(Rational& other) noexcept { mpq_swap(in(storage_), in(other.storage_)); }

}  // namespace radcert
