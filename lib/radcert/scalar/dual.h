// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/exponent.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A value with its two first partial derivatives: forward differentiation of a chart.
/// Maths     f, D_s f, D_t f at one point; (fg)' = f'g + fg', and so on
/// Source    the tangents D_s m_k, D_t m_k of [ac98, (30)]
/// Requires  the function differentiable where it is evaluated
/// Result    each derivative is the formula's own, rounded as the arithmetic R rounds; no step size
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

  /// f^p for f >= 0 and p >= 1.
  friend Dual power(const Dual& f, const Exponent<R>& p) {
    const R slope = p.value() * power(f.value, p.minus_one());
    return {power(f.value, p), f.by_s * slope, f.by_t * slope};
  }
};

}  // namespace radcert
