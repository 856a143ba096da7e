// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"

#include <compare>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace radcert {

/// An exact rational number.
/// Maths     n/d in lowest terms, d >= 1; the field Q
/// Source    GMP (mpq)
/// Requires  a divisor or denominator is not zero, else ContractViolation; exactly(x): x is finite, else
///           ContractViolation
/// Result    + - * / and comparisons are exact; to_double() is the nearest double, ties to even, subnormals
///           included, infinite beyond the largest
/// Limits    numerators and denominators grow without limit: memory is the only bound, and GMP ends the
///           process when it has none
class Rational {
public:
  Rational() noexcept;
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool> && sizeof(Integer) <= 8)
  Rational(Integer value) : Rational() {
    if constexpr (std::signed_integral<Integer>) {
      set_signed(value);
    } else {
      set_unsigned(value);
    }
  }
  Rational(long numerator, long denominator);
  Rational(double) = delete;
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  /// The exact value of a finite double.
  [[nodiscard]] static Rational exactly(double value);

  /// A decimal ("0.1", "-1.5e-3", ".5", "2.") or a fraction of decimals ("1/6", "-0.5/3"), exactly.
  /// Refused, with the reason: malformed text, a zero denominator, a decimal exponent beyond +-400, more than
  /// 1000 characters. A sign stands only in front.
  [[nodiscard]] static Outcome<Rational> parse(std::string_view text);

  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  Rational& operator/=(const Rational& other);
  [[nodiscard]] Rational operator-() const;
  [[nodiscard]] friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  [[nodiscard]] friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  [[nodiscard]] friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  [[nodiscard]] friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
  [[nodiscard]] friend bool operator==(const Rational& a, const Rational& b) { return a.equals(b); }
  [[nodiscard]] friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.compare(b);
  }
  [[nodiscard]] friend Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }
  friend void swap(Rational& a, Rational& b) noexcept { a.exchange(b); }

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const;
  [[nodiscard]] bool is_integer() const;
  [[nodiscard]] Rational numerator() const;
  [[nodiscard]] Rational denominator() const;
  /// The value as a long, where it is an integer that fits.
  [[nodiscard]] std::optional<long> to_long() const;
  [[nodiscard]] double to_double() const;
  /// "n/d", or "n" for an integer, in decimal.
  [[nodiscard]] std::string to_text() const;
  [[nodiscard]] std::string numerator_text() const;
  [[nodiscard]] std::string denominator_text() const;

  /// Points to the mpq_t inside, for sources that include gmp.h.
  [[nodiscard]] const void* gmp() const noexcept { return storage_; }
  /// The value of an mpq_t in lowest terms, for the same sources.
  [[nodiscard]] static Rational from_gmp(const void* mpq);

private:
  void set_signed(long value);
  void set_unsigned(unsigned long value);
  [[nodiscard]] bool equals(const Rational& other) const;
  [[nodiscard]] std::strong_ordering compare(const Rational& other) const;
  void exchange(Rational& other) noexcept;

  alignas(8) std::byte storage_[32];
};

}  // namespace radcert
