// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A finite sum c s^i t^j with rational coefficients and rational exponents i, j >= 0.
/// Maths     by exponents (i, j); no coefficient is zero
/// Source    polynomials, and the powers of [ac98, (94)]
/// Result    the zero function is the empty sum
using PowerSum = std::map<std::array<Rational, 2>, Rational>;

/// A quotient of two sums, the denominator not the zero function.
struct PowerQuotient {
  PowerSum numerator;
  PowerSum denominator;
  friend auto operator<=>(const PowerQuotient& a, const PowerQuotient& b) = default;
};

/// The region of the parameters over which a sign is asked for.
enum class ParameterRegion { square, triangle };

/// A function of two variables s, t >= 0 as an exact expression: the arithmetic in which identities are
/// proved.
/// Maths     sum_k (n_k / d_k) sqrt(g_k1) sqrt(g_k2) ..., n and d sums of powers, each g such a quotient;
///           sqrt(g) sqrt(g) = g and 1 / (c sqrt(g)) = sqrt(g) / (c g)
/// Source    the charts of the catalogue are of this kind
/// Requires  the quotients and roots are taken where they have a value: what is proved here holds where the
///           formula, evaluated in balls, is finite
/// Result    is_zero(): proved, the function vanishes wherever it is defined. A root within a root, a
///           quotient by a sum with roots and every transcendental function is unknown, and so is all that
///           comes of it
/// Limits    is_zero() may miss a zero that needs a relation between different radicands
class ExactFunction {
public:
  /// Zero.
  ExactFunction() = default;
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool>)
  ExactFunction(Integer value)
      : ExactFunction(Rational(value)) {}  // NOLINT(google-explicit-constructor): exact
  explicit ExactFunction(const Rational& constant);
  [[nodiscard]] static ExactFunction s();
  [[nodiscard]] static ExactFunction t();
  [[nodiscard]] static ExactFunction unknown();

  [[nodiscard]] bool is_known() const { return known_; }
  [[nodiscard]] bool is_zero() const { return known_ && terms_.empty(); }
  /// The function as a quotient, where no root is left in it.
  [[nodiscard]] std::optional<PowerQuotient> quotient() const;
  /// f(s, 0); unknown where that is not of the form 0/0 but may be.
  [[nodiscard]] ExactFunction where_t_is_zero() const;

  friend ExactFunction operator-(const ExactFunction& f);
  friend ExactFunction operator+(const ExactFunction& f, const ExactFunction& g);
  friend ExactFunction operator-(const ExactFunction& f, const ExactFunction& g) { return f + (-g); }
  friend ExactFunction operator*(const ExactFunction& f, const ExactFunction& g);
  friend ExactFunction operator/(const ExactFunction& f, const ExactFunction& g) { return f * reciprocal(g); }
  friend ExactFunction reciprocal(const ExactFunction& f);
  friend ExactFunction sqrt(const ExactFunction& f);
  /// Known for the power of s^i t^j by a constant >= 0.
  friend ExactFunction pow(const ExactFunction& f, const ExactFunction& exponent);

private:
  /// The radicands of one term, in order, none twice.
  using Radicands = std::vector<PowerQuotient>;

  friend bool is_nowhere_negative(const ExactFunction& f, ParameterRegion region);
  void add(const Radicands& radicands, const PowerQuotient& factor);

  std::map<Radicands, PowerQuotient> terms_;  ///< no factor is zero
  bool known_ = true;
};

/// Numbers as they enter exact functions: constants.
template <>
struct Constants<ExactFunction> {
  static ExactFunction from_rational(const Rational& q) { return ExactFunction(q); }
};

/// Whether a function is shown to be nowhere negative.
/// Maths     the coefficients of numerator and denominator in Bernstein's basis, of the square [0,1]^2 or of
///           the triangle 0 <= s, t, s + t <= 1, all have one sign: the value is a mean of them with weights
///           that are not negative. Roots are not negative
/// Source    R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", 2012
/// Requires  f has a value on the whole region
/// Result    true: proved, equality included; of several terms with roots each must be so. On the square
///           fractional exponents are no obstacle: s = x^k maps [0,1] onto itself
/// Limits    false says nothing
[[nodiscard]] bool is_nowhere_negative(const ExactFunction& f, ParameterRegion region);

}  // namespace radcert
