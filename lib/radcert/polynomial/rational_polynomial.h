// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert {

/// A polynomial of one variable with rational coefficients, exactly.
/// Maths     sum_k a_k X^k; the ring Q[X]
/// Result    + - * and == are exact; no leading zeros are kept, so that equal polynomials have equal
///           coefficients
/// Limits    products by the schoolbook: for degrees up to a few hundred
class RationalPolynomial {
public:
  /// Zero.
  RationalPolynomial() = default;
  RationalPolynomial(const Rational& constant);  // NOLINT(google-explicit-constructor): exact
  RationalPolynomial(int constant)
      : RationalPolynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  /// The constant term first.
  explicit RationalPolynomial(std::vector<Rational> coefficients);
  /// X.
  [[nodiscard]] static RationalPolynomial variable();

  /// -1 for zero.
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  /// a_k; zero beyond the degree.
  [[nodiscard]] Rational coefficient(std::size_t k) const;
  [[nodiscard]] Rational leading() const;
  [[nodiscard]] Rational operator()(const Rational& x) const;
  [[nodiscard]] RationalPolynomial derivative() const;
  /// "3 x^2 - 1/2 x + 1", "0".
  [[nodiscard]] std::string to_text(std::string_view variable = "x") const;

  RationalPolynomial& operator+=(const RationalPolynomial& other);
  RationalPolynomial& operator-=(const RationalPolynomial& other);
  RationalPolynomial& operator*=(const RationalPolynomial& other);
  [[nodiscard]] RationalPolynomial operator-() const;
  [[nodiscard]] friend RationalPolynomial operator+(RationalPolynomial a, const RationalPolynomial& b) {
    return a += b;
  }
  [[nodiscard]] friend RationalPolynomial operator-(RationalPolynomial a, const RationalPolynomial& b) {
    return a -= b;
  }
  [[nodiscard]] friend RationalPolynomial operator*(RationalPolynomial a, const RationalPolynomial& b) {
    return a *= b;
  }
  friend bool operator==(const RationalPolynomial&, const RationalPolynomial&) = default;

private:
  void trim();
  std::vector<Rational> coefficients_;
};

/// A quotient with its remainder.
struct Division {
  RationalPolynomial quotient;
  RationalPolynomial remainder;
};

/// Division with remainder.
/// Maths     a = q b + r, deg r < deg b
/// Requires  b != 0, else ContractViolation
/// Result    exact
[[nodiscard]] Division divide(const RationalPolynomial& a, const RationalPolynomial& b);

/// The greatest common divisor, with the leading coefficient 1; zero only for two zeros.
[[nodiscard]] RationalPolynomial greatest_common_divisor(RationalPolynomial a, RationalPolynomial b);

}  // namespace radcert
