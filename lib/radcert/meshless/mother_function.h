// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/expression/expression.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The Gaussian bell.
/// Maths     G(r) = exp(-r^2/2)
/// Source    [psg10, (12)]
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
enum class MotherKind : std::uint8_t { gaussian, spline, shepard, expression, own };

/// A mother function of a user's own type, its type erased.
/// Maths     Phi(r)
/// Requires  functions that threads may call at the same time; a name that tells one such function from
///           another
/// Result    plain data, made by own_mother()
/// Limits    in double, and in balls where the type takes them
struct OwnMother {
  std::string name;
  std::function<double(double)> in_double;
  std::function<Ball(const Ball&)> in_balls{};
};

/// The function of the relative distance that all elements of a radial basis share.
/// Maths     Phi(r), and 0 for r > support where a support is set
/// Source    [psg10, section V-A]
/// Result    value<R>(r) in any arithmetic
/// Limits    the Gaussian is cut at 4 as the paper allows: it jumps by exp(-8) = 3.4e-4 there. One with
///           another support, or none, is made by gaussian_mother()
struct MotherFunction {
  MotherKind kind = MotherKind::gaussian;
  Expression expression{};              ///< in r; used where kind is expression
  std::optional<Rational> support = 4;  ///< zero beyond; absent: nowhere zero
  OwnMother own{};                      ///< used where kind is own

  /// Phi(r), for r >= 0.
  template <Real R>
  [[nodiscard]] R value(const R& r) const {
    const R whole = uncut(r);
    if (!support || kind == MotherKind::spline) return whole;
    return select_less(from_rational<R>(*support), r, R(0), whole);
  }

  /// Whether Phi >= 0 and Phi decreases: known of those that have a name.
  [[nodiscard]] bool is_monotone() const { return kind != MotherKind::expression && kind != MotherKind::own; }
  /// "gaussian", "spline", "shepard", the expression as written, or the name of a user's own.
  [[nodiscard]] std::string to_text() const;

private:
  template <Real R>
  [[nodiscard]] R uncut(const R& r) const {
    switch (kind) {
      case MotherKind::gaussian: return gaussian_bell(r);
      case MotherKind::spline: return spline_bell(r);
      case MotherKind::shepard: return inverse_square(r);
      case MotherKind::own: return value_of_own(r);
      case MotherKind::expression: break;
    }
    return expression.evaluate_radial(r);
  }
  template <Real R>
  [[nodiscard]] R value_of_own(const R& r) const {
    if constexpr (std::same_as<R, double>) {
      return own.in_double(r);
    } else {
      constexpr bool is_ball = std::same_as<R, Ball>;
      expects(is_ball && own.in_balls, "a mother function with values in this arithmetic",
              named("name", own.name));
      if constexpr (is_ball) return own.in_balls(r);
      return r;
    }
  }
};

/// The functions that have names: gaussian_bell, spline_bell, and inverse_square of Shepard.
/// Requires  a positive support, or none, else ContractViolation
[[nodiscard]] MotherFunction gaussian_mother(std::optional<Rational> support = 4);
[[nodiscard]] MotherFunction spline_mother();
[[nodiscard]] MotherFunction shepard_mother();
/// ContractViolation unless the expression is in r and the support, where there is one, positive.
[[nodiscard]] MotherFunction expression_mother(Expression in_r,
                                               std::optional<Rational> support = std::nullopt);

/// A mother function of one's own type.
/// Maths     Phi(r), cut at the support where there is one
/// Requires  phi(r) for a double r >= 0, safe to call from several threads; a support > 0 or none, a name
///           that is not empty, else ContractViolation
/// Result    as phi rounds; in balls too, where phi takes a Ball and gives one
/// Limits    nothing is known of phi but its values: it counts as not monotone
template <class Phi>
  requires std::is_invocable_r_v<double, const Phi&, const double&>
[[nodiscard]] MotherFunction own_mother(std::string name, Phi phi,
                                        std::optional<Rational> support = std::nullopt) {
  expects(!name.empty(), "a name");
  expects(!support || *support > Rational(0), "a support > 0 or none", named("name", name));
  MotherFunction mother{.kind = MotherKind::own, .support = std::move(support)};
  mother.own = {.name = std::move(name), .in_double = [phi](double r) { return phi(r); }};
  if constexpr (std::is_invocable_r_v<Ball, const Phi&, const Ball&>)
    mother.own.in_balls = [phi](const Ball& r) { return phi(r); };
  return mother;
}

}  // namespace radcert
