// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert::verification {

/// A polynomial of several variables with rational coefficients, exactly.
/// Maths     sum_k a_k X^k, k over exponents of named variables; the ring Q[x, y, ...]
/// Result    + - * and == are exact; no terms with the coefficient 0 are kept, so that equal polynomials have
///           equal terms
class Polynomial {
public:
  /// The exponents that are not 0.
  using Monomial = std::map<std::string, int>;

  /// Zero.
  Polynomial() = default;
  Polynomial(const Rational& constant);                         // NOLINT(google-explicit-constructor): exact
  Polynomial(int constant) : Polynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] static Polynomial variable(const std::string& name);

  [[nodiscard]] const std::map<Monomial, Rational>& terms() const { return terms_; }
  /// This polynomial with another one in the place of the square of a variable.
  /// Requires  a square without the variable, else ContractViolation
  [[nodiscard]] Polynomial with_square(const std::string& name, const Polynomial& square) const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  [[nodiscard]] Polynomial operator-() const { return Polynomial() - *this; }
  friend bool operator==(const Polynomial&, const Polynomial&) = default;

private:
  void add(const Monomial& monomial, const Rational& coefficient);
  std::map<Monomial, Rational> terms_;
};

/// A quotient of polynomials of several variables: the arithmetic in which a formula is run once for all
/// values of its variables.
/// Maths     the field Q(x, y, ...)
/// Result    exact; models Field
/// Limits    no common factors are cancelled: for formulas of a few operations. What holds in it holds
///           wherever no divisor is 0
struct RationalFunction {
  Polynomial above;
  Polynomial below = 1;

  RationalFunction() = default;
  RationalFunction(Polynomial polynomial)
      : above(std::move(polynomial)) {}                            // NOLINT(google-explicit-constructor)
  RationalFunction(const Rational& constant) : above(constant) {}  // NOLINT(google-explicit-constructor)
  RationalFunction(int constant) : above(constant) {}              // NOLINT(google-explicit-constructor)
  [[nodiscard]] static RationalFunction variable(const std::string& name) {
    return Polynomial::variable(name);
  }

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  /// ContractViolation where b is 0.
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);
  [[nodiscard]] RationalFunction operator-() const;
  /// Whether they are one function.
  friend bool operator==(const RationalFunction& a, const RationalFunction& b) {
    return a.above * b.below == b.above * a.below;
  }
  RationalFunction& operator+=(const RationalFunction& other) { return *this = *this + other; }
};

/// x^2 = square, as for the sine and the cosine of an angle or the coordinates of a unit vector.
struct SquareRule {
  std::string name;
  Polynomial square;
};

/// In how many terms two functions differ.
/// Maths     the number of terms of a_above b_below - b_above a_below, after each rule in turn
/// Result    0 proves a = b for all values that meet the rules and at which no divisor is 0
[[nodiscard]] Rational differing_terms(const RationalFunction& a, const RationalFunction& b,
                                       std::span<const SquareRule> rules = {});

/// How many terms of the numerator and of the denominator have a negative coefficient.
/// Result    0 proves f >= 0 wherever no variable is negative and the denominator is not 0
[[nodiscard]] Rational negative_terms(const RationalFunction& f);

}  // namespace radcert::verification

namespace radcert {

template <>
struct Constants<verification::RationalFunction> {
  static verification::RationalFunction from_rational(const Rational& q) { return q; }
};

}  // namespace radcert
