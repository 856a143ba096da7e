// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/exponent.h"
#include "radcert/scalar/functions/power_difference.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A function of one variable seen from two arguments p and q = p + step: values, slopes and divided
/// differences.
/// Maths     f[p,q] = (f(q) - f(p)) / step,  f[p,p,q] = (f[p,q] - f'(p)) / step,  f[p,q,q] = (f'(q) - f[p,q])
///           / step, carried through + - * / sqrt and powers by the rule of Leibniz, (fg)[p,q] = f[p,q] g(q)
///           + f(p) g[p,q], (fg)[p,p,q] = f[p,p,q] g(q) + f'(p) g[p,q] + f(p) g[p,p,q], and by the chain rule
/// Source    Leibniz's rule for divided differences; the use for (Q-P).n_P is ours: see Chord
/// Requires  f twice differentiable between p and q, or at least off one end (then f[p,p,q] stays finite)
/// Result    no digits are lost as step -> 0: nothing here subtracts nearly equal function values;
///           the step itself enters only through `variable`
/// Limits    one direction, second order; step may be zero (then f[p,p,q] = f''(p) / 2)
template <Field R>
struct DividedDifference {
  R at_p{};
  R at_q{};
  R slope_p{};
  R slope_q{};
  R first{};
  R second_p{};
  R second_q{};
  R step{};

  DividedDifference() = default;
  explicit DividedDifference(const R& constant)
      : at_p(constant),
        at_q(constant),
        slope_p(R(0)),
        slope_q(R(0)),
        first(R(0)),
        second_p(R(0)),
        second_q(R(0)),
        step(R(0)) {}
  explicit DividedDifference(int constant) : DividedDifference(R(constant)) {}

  /// The linear function p + step * direction.
  [[gnu::always_inline]] static DividedDifference variable(const R& p, const R& direction, const R& step) {
    DividedDifference f;
    f.at_p = p;
    f.at_q = p + step * direction;
    f.slope_p = f.slope_q = f.first = direction;
    f.second_p = f.second_q = R(0);
    f.step = step;
    return f;
  }

  [[gnu::always_inline]] friend DividedDifference operator-(const DividedDifference& f) { return R(-1) * f; }

  [[gnu::always_inline]] friend DividedDifference operator+(const DividedDifference& f,
                                                            const DividedDifference& g) {
    DividedDifference h;
    h.at_p = f.at_p + g.at_p;
    h.at_q = f.at_q + g.at_q;
    h.slope_p = f.slope_p + g.slope_p;
    h.slope_q = f.slope_q + g.slope_q;
    h.first = f.first + g.first;
    h.second_p = f.second_p + g.second_p;
    h.second_q = f.second_q + g.second_q;
    h.step = either_step(f, g);
    return h;
  }

  [[gnu::always_inline]] friend DividedDifference operator-(const DividedDifference& f,
                                                            const DividedDifference& g) {
    return f + (-g);
  }

  [[gnu::always_inline]] friend DividedDifference operator*(const R& c, const DividedDifference& f) {
    DividedDifference h;
    h.at_p = c * f.at_p;
    h.at_q = c * f.at_q;
    h.slope_p = c * f.slope_p;
    h.slope_q = c * f.slope_q;
    h.first = c * f.first;
    h.second_p = c * f.second_p;
    h.second_q = c * f.second_q;
    h.step = f.step;
    return h;
  }
  [[gnu::always_inline]] friend DividedDifference operator+(const R& c, const DividedDifference& f) {
    DividedDifference h = f;
    h.at_p = c + f.at_p;
    h.at_q = c + f.at_q;
    return h;
  }
  [[gnu::always_inline]] friend DividedDifference operator-(const R& c, const DividedDifference& f) {
    return c + (-f);
  }

  [[gnu::always_inline]] friend DividedDifference operator*(const DividedDifference& f,
                                                            const DividedDifference& g) {
    DividedDifference h;
    h.at_p = f.at_p * g.at_p;
    h.at_q = f.at_q * g.at_q;
    h.slope_p = f.slope_p * g.at_p + f.at_p * g.slope_p;
    h.slope_q = f.slope_q * g.at_q + f.at_q * g.slope_q;
    h.first = f.first * g.at_q + f.at_p * g.first;
    h.second_p = f.second_p * g.at_q + f.slope_p * g.first + f.at_p * g.second_p;
    h.second_q = f.second_q * g.at_q + f.first * g.slope_q + f.at_p * g.second_q;
    h.step = either_step(f, g);
    return h;
  }

  /// The reciprocal h = 1/g from the product g h = 1, order by order.
  [[gnu::always_inline]] friend DividedDifference reciprocal(const DividedDifference& g) {
    DividedDifference h;
    h.at_p = R(1) / g.at_p;
    h.at_q = R(1) / g.at_q;
    h.slope_p = -(h.at_p * h.at_p * g.slope_p);
    h.slope_q = -(h.at_q * h.at_q * g.slope_q);
    h.first = -(h.at_p * h.at_q * g.first);
    h.second_p = -(h.slope_p * g.first + h.at_p * g.second_p) * h.at_q;
    h.second_q = -(h.first * g.slope_q + h.at_p * g.second_q) * h.at_q;
    h.step = g.step;
    return h;
  }

  [[gnu::always_inline]] friend DividedDifference operator/(const DividedDifference& f,
                                                            const DividedDifference& g) {
    return f * reciprocal(g);
  }

  /// The root h from the product f = h h, order by order.
  [[gnu::always_inline]] friend DividedDifference sqrt(const DividedDifference& f) {
    using std::sqrt;
    DividedDifference h;
    h.at_p = sqrt(f.at_p);
    h.at_q = sqrt(f.at_q);
    h.slope_p = f.slope_p / (h.at_p + h.at_p);
    h.slope_q = f.slope_q / (h.at_q + h.at_q);
    const R inverse_sum = R(1) / (h.at_p + h.at_q);
    h.first = f.first * inverse_sum;
    h.second_p = (f.second_p - h.slope_p * h.first) * inverse_sum;
    h.second_q = (f.second_q - h.first * h.slope_q) * inverse_sum;
    h.step = f.step;
    return h;
  }

  /// f^e for f >= 0 and e >= 1; a whole e is a product.
  friend DividedDifference power(const DividedDifference& f, const Exponent<R>& e) {
    if (e.is_whole()) return power(f, e.whole());
    const R increment = f.step * f.first;
    const R slope_at_p = e.value() * power(f.at_p, e.minus_one());
    const R slope_at_q = e.value() * power(f.at_q, e.minus_one());
    const R bend_p = bend(f.at_p, f.at_q, increment, f.first, e);
    const R bend_q = bend(f.at_q, f.at_p, -increment, f.first, e);
    DividedDifference h;
    h.at_p = power(f.at_p, e);
    h.at_q = power(f.at_q, e);
    h.slope_p = slope_at_p * f.slope_p;
    h.slope_q = slope_at_q * f.slope_q;
    if constexpr (Enclosing<R>) {
      h.first = first_of_power(f.at_p, f.at_q, increment, e.value(), bend_p) * f.first;
    } else {
      h.first = (slope_at_p + increment * bend_p) * f.first;
    }
    h.second_p = bend_p * f.first * f.first + slope_at_p * f.second_p;
    h.second_q = bend_q * f.first * f.first + slope_at_q * f.second_q;
    h.step = f.step;
    return h;
  }

private:
  template <Field>
  friend struct DividedDifference;

  /// A constant has no step of its own.
  [[gnu::always_inline]] static R either_step(const DividedDifference& f, const DividedDifference& g) {
    return certainly_zero(f.step) ? g.step : f.step;
  }

  /// phi[a,a,b] for phi(x) = x^e, b = a + d; any number where f is constant, because then zero multiplies it.
  static R bend(const R& a, const R& b, const R& d, const R& first, const Exponent<R>& e) {
    if constexpr (Enclosing<R>) {
      return certainly_zero(first) ? R(0) : bend_of_power(a, b, d, e.value());
    } else if constexpr (std::is_same_v<R, Pack>) {
      const Exponent<double> of_lane = e.in(e.value().lane(0));
      return by_lane(
          [&of_lane](double x, double y, double step) {
            return DividedDifference<double>::bend_in_one_lane(x, y, step, of_lane);
          },
          a, b, d);
    } else {
      return bend_in_one_lane(a, b, d, e);
    }
  }

  /// The binomial series in d/a for |d| <= a/2, else the definition, where the subtraction costs a few digits
  /// at most.
  static R bend_in_one_lane(const R& a, const R& b, const R& d, const Exponent<R>& e) {
    using std::abs;
    if (a == R(0) && d == R(0))
      return R(0);  // for e < 2 not its value, but then f is constant and the factor is zero
    if (abs(d + d) <= a) {
      const R x = d / a;
      R term = e.value() * (e.value() - R(1)) / R(2);
      R sum = term;
      for (int k = 2; abs(term) > unit_roundoff<R>() * abs(sum); ++k) {
        term = term * x * (e.value() - R(k)) / R(k + 1);
        sum = sum + term;
      }
      return sum * power(a, e.minus_one()) / a;
    }
    return (power(b, e) - power(a, e) - e.value() * power(a, e.minus_one()) * d) / (d * d);
  }
};

}  // namespace radcert
