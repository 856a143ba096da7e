// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "radcert/expression/expression.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The Gaussian bell.
/// Maths     G(r) = exp(-r^2/2)
/// Source    [psg10, (12)]
/// Requires  -
/// Result    as R rounds; enclosed in balls
/// Limits    not cut: see MotherFunction
template <Real R>
R gaussian_bell(const R& r) {
  using std::exp;
  return exp(-(r * r) / R(2));
}

/// The spline bell.
/// Maths     K(r) = 2r^3 - 3r^2 + 1 = (1-r)^2 (1+2r) for r < 1, else 0
/// Source    [psg10, (13)]
/// Requires  r >= 0
/// Result    as R rounds, never negative in double: that is why it is factored; enclosed in balls
/// Limits    continuously differentiable; the second derivative jumps by 6 at r = 1
template <Field R>
R spline_bell(const R& r) {
  return select_less(r, R(1), R(power(R(1) - r, 2) * (R(1) + R(2) * r)), R(0));
}

/// Shepard's mother function.
/// Maths     S(r) = 1/r^2
/// Source    [psg10, (14)]
/// Requires  r > 0
/// Result    as R rounds; enclosed in balls
/// Limits    unbounded at 0: what a basis made of it is there, say the bases
template <Field R>
R inverse_square(const R& r) {
  return R(1) / (r * r);
}

/// Which mother function.
enum class MotherKind : std::uint8_t { gaussian, spline, shepard, expression };

/// The function of the relative distance that all elements of a radial basis share.
/// Maths     Phi(r), and 0 for r > support where a support is set
/// Source    [psg10, section V-A]
/// Requires  -
/// Result    value<R>(r) in any arithmetic
/// Limits    the Gaussian is cut at 4 as the paper allows: it jumps by exp(-8) = 3.4e-4 there. One with another support, or none, is
///           made by gaussian_mother()
struct MotherFunction {
  MotherKind kind = MotherKind::gaussian;
  Expression expression{};              ///< in r; used where kind is expression
  std::optional<Rational> support = 4;  ///< zero beyond; absent: nowhere zero

  /// Phi(r), for r >= 0.
  template <Real R>
  [[nodiscard]] R value(const R& r) const {
    const R whole = uncut(r);
    if (!support || kind == MotherKind::spline) return whole;
    return select_less(from_rational<R>(*support), r, R(0), whole);
  }

  /// Whether Phi >= 0 and Phi decreases: known of those that have a name.
  [[nodiscard]] bool is_monotone() const { return kind != MotherKind::expression; }
  /// "gaussian", "spline", "shepard", or the expression as written.
  [[nodiscard]] std::string to_text() const;

private:
  template <Real R>
  [[nodiscard]] R uncut(const R& r) const {
    switch (kind) {
      case MotherKind::gaussian: return gaussian_bell(r);
      case MotherKind::spline: return spline_bell(r);
      case MotherKind::shepard: return inverse_square(r);
      case MotherKind::expression: break;
    }
    return expression.evaluate_radial(r);
  }
};

[[nodiscard]] MotherFunction gaussian_mother(std::optional<Rational> support = 4);
[[nodiscard]] MotherFunction spline_mother();
[[nodiscard]] MotherFunction shepard_mother();
/// ContractViolation unless the expression is in r and the support, where there is one, positive.
[[nodiscard]] MotherFunction expression_mother(Expression in_r,
                                               std::optional<Rational> support = std::nullopt);

}  // namespace radcert
