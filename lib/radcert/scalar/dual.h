// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/exponent.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A value with its two first partial derivatives: forward differentiation of a chart.
/// Maths     f, D_s f, D_t f at one point; (fg)' = f'g + fg', and so on; abs, min and max have the derivative
///           of the branch taken, min and max that of the first argument at a tie, abs that of +f at zero
/// Source    the tangents D_s m_k, D_t m_k of [ac98, (30)]
/// Requires  the function differentiable where it is evaluated
/// Result    each derivative is the formula's own, rounded as the arithmetic R rounds; no step size. R =
///           Ball: encloses the derivatives at all points of the operands; where abs, min or max may switch,
///           the hull of both branches, which then contains every difference quotient's limit as well
/// Limits    first order only
template <Field R>
struct Dual {
  R value{};
  R by_s{};
  R by_t{};

  Dual() = default;
  explicit Dual(const R& constant) : value(constant), by_s(R(0)), by_t(R(0)) {}
  explicit Dual(int constant) : Dual(R(constant)) {}
  Dual(const R& v, const R& s, const R& t) : value(v), by_s(s), by_t(t) {}

  friend Dual operator-(const Dual& f) { return {-f.value, -f.by_s, -f.by_t}; }
  friend Dual operator+(const Dual& f, const Dual& g) {
    return {f.value + g.value, f.by_s + g.by_s, f.by_t + g.by_t};
  }
  friend Dual operator-(const Dual& f, const Dual& g) {
    return {f.value - g.value, f.by_s - g.by_s, f.by_t - g.by_t};
  }
  friend Dual operator*(const Dual& f, const Dual& g) {
    return {f.value * g.value, f.by_s * g.value + f.value * g.by_s, f.by_t * g.value + f.value * g.by_t};
  }
  friend Dual reciprocal(const Dual& g) {
    const R inverse = R(1) / g.value;
    const R slope = -(inverse * inverse);
    return {inverse, slope * g.by_s, slope * g.by_t};
  }
  friend Dual operator/(const Dual& f, const Dual& g) { return f * reciprocal(g); }
  friend Dual operator+(const R& c, const Dual& f) { return {c + f.value, f.by_s, f.by_t}; }
  friend Dual operator-(const R& c, const Dual& f) { return {c - f.value, -f.by_s, -f.by_t}; }
  friend Dual operator*(const R& c, const Dual& f) { return {c * f.value, c * f.by_s, c * f.by_t}; }

  friend Dual sqrt(const Dual& f) {
    using std::sqrt;
    const R root = sqrt(f.value);
    const R slope = R(1) / (root + root);
    return {root, f.by_s * slope, f.by_t * slope};
  }
  friend Dual exp(const Dual& f) {
    using std::exp;
    const R e = exp(f.value);
    return {e, e * f.by_s, e * f.by_t};
  }
  friend Dual log(const Dual& f) {
    using std::log;
    return {log(f.value), f.by_s / f.value, f.by_t / f.value};
  }
  friend Dual sin(const Dual& f) {
    using std::cos, std::sin;
    const R slope = cos(f.value);
    return {sin(f.value), slope * f.by_s, slope * f.by_t};
  }
  friend Dual cos(const Dual& f) {
    using std::cos, std::sin;
    const R slope = -sin(f.value);
    return {cos(f.value), slope * f.by_s, slope * f.by_t};
  }
  friend Dual tan(const Dual& f) {
    using std::tan;
    const R tangent = tan(f.value);
    const R slope = R(1) + tangent * tangent;
    return {tangent, slope * f.by_s, slope * f.by_t};
  }
  friend Dual atan(const Dual& f) {
    using std::atan;
    const R slope = R(1) / (R(1) + f.value * f.value);
    return {atan(f.value), slope * f.by_s, slope * f.by_t};
  }

  /// f^n, as the product.
  friend Dual power(const Dual& f, long n) {
    if (n == 0) return Dual(1);
    const R slope = R(n) * power(f.value, n - 1);
    return {power(f.value, n), slope * f.by_s, slope * f.by_t};
  }
  /// f^p for f >= 0 and p >= 1.
  friend Dual power(const Dual& f, const Exponent<R>& p) {
    const R slope = p.value() * power(f.value, p.minus_one());
    return {power(f.value, p), f.by_s * slope, f.by_t * slope};
  }
  /// f^g: g f^(g-1) f' + f^g log(f) g', without the second part where g is constant, so that f may be zero or
  /// negative as far as pow of R admits it.
  friend Dual pow(const Dual& f, const Dual& g) {
    using std::log, std::pow;
    const R value = pow(f.value, g.value);
    const R slope = certainly_zero(g.value) ? R(0) : g.value * pow(f.value, g.value - R(1));
    if (certainly_zero(g.by_s) && certainly_zero(g.by_t)) return {value, slope * f.by_s, slope * f.by_t};
    const R growth = value * log(f.value);
    return {value, slope * f.by_s + growth * g.by_s, slope * f.by_t + growth * g.by_t};
  }

  friend Dual abs(const Dual& f) {
    using std::abs;
    return {abs(f.value), select_less(f.value, R(0), -f.by_s, f.by_s),
            select_less(f.value, R(0), -f.by_t, f.by_t)};
  }
  friend Dual min(const Dual& f, const Dual& g) {
    return {smaller_of(f.value, g.value), select_less(g.value, f.value, g.by_s, f.by_s),
            select_less(g.value, f.value, g.by_t, f.by_t)};
  }
  friend Dual max(const Dual& f, const Dual& g) {
    return {larger_of(f.value, g.value), select_less(f.value, g.value, g.by_s, f.by_s),
            select_less(f.value, g.value, g.by_t, f.by_t)};
  }
  friend Dual hull(const Dual& f, const Dual& g) requires Enclosing<R> {
    return {hull(f.value, g.value), hull(f.by_s, g.by_s), hull(f.by_t, g.by_t)};
  }
};

/// Numbers as they enter Dual: constants, whose derivatives are 0.
template <class R>
struct Constants<Dual<R>> {
  static Dual<R> from_rational(const Rational& q) { return Dual<R>(radcert::from_rational<R>(q)); }
  static Dual<R> pi() { return Dual<R>(radcert::pi<R>()); }
};

}  // namespace radcert
