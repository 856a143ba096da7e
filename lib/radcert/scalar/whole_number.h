// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/scalar/rational.h"

namespace radcert {

/// A whole number of any size: rational numbers without the search for common divisors.
/// Maths     the ring Z
/// Source    GMP (mpz)
/// Requires  scaled(x, e): x finite and x 2^(-e) whole, else ContractViolation
/// Result    exact
/// Limits    memory is the only bound
class WholeNumber {
public:
  WholeNumber() noexcept;
  /// x 2^(-exponent).
  static WholeNumber scaled(double x, int exponent);
  WholeNumber(const WholeNumber& other);
  WholeNumber(WholeNumber&& other) noexcept;
  WholeNumber& operator=(const WholeNumber& other);
  WholeNumber& operator=(WholeNumber&& other) noexcept;
  ~WholeNumber();

  [[nodiscard]] WholeNumber operator-() const;
  [[nodiscard]] friend WholeNumber operator+(const WholeNumber& a, const WholeNumber& b) { return a.plus(b); }
  [[nodiscard]] friend WholeNumber operator-(const WholeNumber& a, const WholeNumber& b) {
    return a.minus(b);
  }
  [[nodiscard]] friend WholeNumber operator*(const WholeNumber& a, const WholeNumber& b) {
    return a.times(b);
  }

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const;
  /// The number of binary digits of the size; 0 for zero.
  [[nodiscard]] std::size_t bit_count() const;
  /// The number times 2^(-bits), cut off towards zero; ContractViolation unless it fits into 64 bits.
  [[nodiscard]] long double shifted_down(std::size_t bits) const;
  [[nodiscard]] Rational to_rational() const;

private:
  [[nodiscard]] WholeNumber plus(const WholeNumber& other) const;
  [[nodiscard]] WholeNumber minus(const WholeNumber& other) const;
  [[nodiscard]] WholeNumber times(const WholeNumber& other) const;

  alignas(8) std::byte storage_[16];
};

/// a / b within 2^-61 of itself; b != 0, else ContractViolation.
[[nodiscard]] long double quotient(const WholeNumber& a, const WholeNumber& b);

/// The exponent of the lowest binary digit of a finite double that is not zero; the largest int for zero.
[[nodiscard]] int lowest_exponent(double x);

}  // namespace radcert
