// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/whole_number.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gmp.h>
#include <limits>
#include <new>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

static_assert(sizeof(mpz_t) == 16 && alignof(mpz_t) == 8);

mpz_ptr in(std::byte* storage) { return std::launder(reinterpret_cast<mpz_ptr>(storage)); }
mpz_srcptr in(const std::byte* storage) { return std::launder(reinterpret_cast<mpz_srcptr>(storage)); }

constexpr int mantissa_bits = std::numeric_limits<double>::digits;

/// x = mantissa 2^exponent.
struct Binary {
  std::int64_t mantissa;
  int exponent;
};

Binary binary(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, mantissa_bits)), exponent - mantissa_bits};
}

}  // namespace

WholeNumber::WholeNumber() noexcept {
  ::new (static_cast<void*>(storage_)) mpz_t;
  mpz_init(in(storage_));
}

WholeNumber WholeNumber::scaled(double x, int exponent) {
  WholeNumber result;
  if (x == 0) return result;
  expects(std::isfinite(x), "a finite number", named("x", x));
  expects(lowest_exponent(x) >= exponent, "a multiple of 2^exponent", named("x", x),
          named("exponent", exponent));
  const Binary b = binary(x);
  mpz_ptr z = in(result.storage_);
  mpz_set_si(z, b.mantissa);
  const int shift = b.exponent - exponent;
  if (shift >= 0) {
    mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(shift));
  } else {
    mpz_tdiv_q_2exp(z, z, static_cast<mp_bitcnt_t>(-shift));
  }
  return result;
}

WholeNumber::WholeNumber(const WholeNumber& other) {
  ::new (static_cast<void*>(storage_)) mpz_t;
  mpz_init_set(in(storage_), in(other.storage_));
}

WholeNumber::WholeNumber(WholeNumber&& other) noexcept : WholeNumber() {
  mpz_swap(in(storage_), in(other.storage_));
}

WholeNumber& WholeNumber::operator=(const WholeNumber& other) {
  if (this != &other) mpz_set(in(storage_), in(other.storage_));
  return *this;
}

WholeNumber& WholeNumber::operator=(WholeNumber&& other) noexcept {
  mpz_swap(in(storage_), in(other.storage_));
  return *this;
}

WholeNumber::~WholeNumber() { mpz_clear(in(storage_)); }

WholeNumber WholeNumber::operator-() const {
  WholeNumber result;
  mpz_neg(in(result.storage_), in(storage_));
  return result;
}

WholeNumber WholeNumber::plus(const WholeNumber& other) const {
  WholeNumber result;
  mpz_add(in(result.storage_), in(storage_), in(other.storage_));
  return result;
}

WholeNumber WholeNumber::minus(const WholeNumber& other) const {
  WholeNumber result;
  mpz_sub(in(result.storage_), in(storage_), in(other.storage_));
  return result;
}

WholeNumber WholeNumber::times(const WholeNumber& other) const {
  WholeNumber result;
  mpz_mul(in(result.storage_), in(storage_), in(other.storage_));
  return result;
}

int WholeNumber::sign() const { return mpz_sgn(in(storage_)); }

std::size_t WholeNumber::bit_count() const { return sign() == 0 ? 0 : mpz_sizeinbase(in(storage_), 2); }

long double WholeNumber::shifted_down(std::size_t bits) const {
  constexpr std::size_t word = 64;
  expects(bit_count() <= bits + word, "a shift that leaves 64 bits", named("bits", bits));
  WholeNumber shifted;
  mpz_tdiv_q_2exp(in(shifted.storage_), in(storage_), bits);
  return static_cast<long double>(sign()) * static_cast<long double>(mpz_get_ui(in(shifted.storage_)));
}

Rational WholeNumber::to_rational() const {
  CValue<__mpq_struct, mpq_init, mpq_clear> q;
  mpq_set_z(q, in(storage_));
  return Rational::from_gmp(q);
}

long double quotient(const WholeNumber& a, const WholeNumber& b) {
  constexpr std::size_t word = 64;
  expects(b.sign() != 0, "a divisor that is not zero");
  // Each is cut off below its leading 64 binary digits.
  const auto leave = [](const WholeNumber& x) { return x.bit_count() > word ? x.bit_count() - word : 0; };
  const std::size_t of_a = leave(a);
  const std::size_t of_b = leave(b);
  return std::ldexp(a.shifted_down(of_a) / b.shifted_down(of_b),
                    static_cast<int>(of_a) - static_cast<int>(of_b));
}

int lowest_exponent(double x) {
  if (x == 0) return std::numeric_limits<int>::max();
  const Binary b = binary(x);
  return b.exponent + std::countr_zero(static_cast<std::uint64_t>(b.mantissa));
}

}  // namespace radcert
