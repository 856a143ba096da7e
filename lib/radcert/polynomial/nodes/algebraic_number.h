// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/real_zeros.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// A real zero of a polynomial with rational coefficients.
/// Maths     the one zero x of a polynomial in an enclosure. Its degree and its Mahler measure M(x) are at
///           most the degree of the square-free part p, written with whole coefficients, and |p|_2, the root
///           of the sum of their squares
/// Source    Landau's inequality M(p) <= |p|_2; M is multiplicative and at least 1 for whole polynomials
///           other than zero
/// Requires  exactly one zero in the enclosure, which is no single point, else ContractViolation
/// Result    value(): a ball about x, to about the current precision of balls, by Newton's method in
///           intervals; degree() and log_measure() bound from above
/// Limits    the bounds are those of the polynomial: one of larger degree than needed makes later proofs
///           longer, not wrong
class AlgebraicNumber {
public:
  AlgebraicNumber(const RationalPolynomial& polynomial, const RealZero& enclosure);
  [[nodiscard]] int degree() const { return polynomial_.degree(); }
  [[nodiscard]] Ball log_measure() const;
  [[nodiscard]] Ball value() const;

private:
  [[nodiscard]] RealZero narrower(const RealZero& zero) const;
  RationalPolynomial polynomial_;  ///< square-free, whole coefficients without a common factor
  RationalPolynomial derivative_;
  RealZero enclosure_;
};

class AlgebraicField;

/// A number made of rational and given algebraic numbers.
/// Maths     sums, differences, products and quotients
/// Requires  numbers by their places in an AlgebraicField; a divisor that is not zero: AlgebraicField::sign
///           tells
/// Result    value: a ball about it, from balls about the numbers. height: an upper bound of [K : Q] h, K the
///           field that the numbers generate, h the absolute logarithmic Weil height
class AlgebraicExpression {
public:
  AlgebraicExpression(const Rational& value);  // NOLINT(google-explicit-constructor): exact
  [[nodiscard]] static AlgebraicExpression number(std::size_t place);

  [[nodiscard]] Ball value(std::span<const Ball> numbers) const;
  [[nodiscard]] Ball height(const AlgebraicField& field) const;

  [[nodiscard]] AlgebraicExpression operator-() const;
  [[nodiscard]] friend AlgebraicExpression operator+(const AlgebraicExpression& a,
                                                     const AlgebraicExpression& b) {
    return a.joined(b, Kind::add);
  }
  [[nodiscard]] friend AlgebraicExpression operator-(const AlgebraicExpression& a,
                                                     const AlgebraicExpression& b) {
    return a.joined(b, Kind::subtract);
  }
  [[nodiscard]] friend AlgebraicExpression operator*(const AlgebraicExpression& a,
                                                     const AlgebraicExpression& b) {
    return a.joined(b, Kind::multiply);
  }
  [[nodiscard]] friend AlgebraicExpression operator/(const AlgebraicExpression& a,
                                                     const AlgebraicExpression& b) {
    return a.joined(b, Kind::divide);
  }

private:
  enum class Kind { rational, number, negate, add, subtract, multiply, divide };
  struct Term {
    Kind kind;
    Rational rational{};
    std::size_t place = 0;
  };
  AlgebraicExpression() = default;
  [[nodiscard]] AlgebraicExpression joined(const AlgebraicExpression& other, Kind kind) const;
  std::vector<Term> terms_;  ///< operands before their operation
};

/// Algebraic numbers together, and what is zero among the numbers that they generate.
/// Maths     K = Q(x_1, ..., x_m), [K : Q] <= N, the product of the degrees. For a in K other than zero
///               |a| >= exp(-[K : Q] h(a)),
///           as the product of all absolute values of a is 1 and each is at most its part of the height.
///           Heights follow the rules h(a + b), h(a - b) <= h(a) + h(b) + log 2,  h(a b), h(a/b) <= h(a) +
///           h(b),  h(p/q) = log max(|p|, |q|), [K : Q] h(x_k) <= (N/degree_k) log M(x_k)
/// Source    Liouville's inequality: Waldschmidt, "Diophantine Approximation on Linear Algebraic Groups",
///           section 3.5
/// Requires  numbers() as many values as a field has numbers
/// Result    sign: decided, by more and more bits until a ball excludes zero or lies so close to it that the
///           number is zero
/// Limits    sign: a reason in place of the answer where more than `most_bits` would be needed
class AlgebraicField {
public:
  explicit AlgebraicField(std::vector<AlgebraicNumber> numbers);
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  /// Balls about the numbers, at the current precision.
  [[nodiscard]] std::vector<Ball> values() const;
  /// N.
  [[nodiscard]] Ball degree() const { return degree_; }
  /// Upper bounds of [K : Q] h.
  [[nodiscard]] Ball height(std::size_t place) const;
  [[nodiscard]] Ball height(const Rational& value) const;
  /// The same for a list of rational numbers: the sum over all absolute values of log max(1, |c_1|, |c_2|,
  /// ...).
  [[nodiscard]] Ball height(std::span<const Rational> values) const;
  /// -1, 0 or 1.
  [[nodiscard]] Outcome<int> sign(const AlgebraicExpression& a, long most_bits = usual_bits) const;

  static constexpr long usual_bits = 1L << 18;

private:
  std::vector<AlgebraicNumber> numbers_;
  Ball degree_;
};

/// Whether a number of the field of a known height is zero, by a ball about it: true, false, or no answer
/// where the ball is too wide.
[[nodiscard]] std::optional<bool> is_zero(const Ball& value, const Ball& height);

/// How many bits behind the point a ball needs for that.
[[nodiscard]] long bits_for(const Ball& height);

/// The bits to try after these, where so many decide in any case: a number that is not zero mostly shows it
/// far earlier.
[[nodiscard]] long more_bits(long bits, long wanted);

}  // namespace radcert
