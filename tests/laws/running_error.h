// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

#include "radcert/scalar/exponent.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert::laws {

/// A number of a rounding arithmetic R together with a bound of what rounding has done to it so far.
/// Maths     value v and bound e with |v - exact| <= e, exact the value of the same formula without any
///           rounding. An operation v = fl(a o b) has  e = sup { |A o B - a o b| : |A - a| <= e_a, |B - b| <=
///           e_b } + k u |v|, the supremum bounded in closed form beside the operation; u is the unit
///           roundoff of R, k = 1 for + - * / fma sqrt and every function of Mpfr, which round to nearest, k
///           = 2 for the functions of libm
/// Source    running error analysis: N. J. Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed.
///           2002, section 3.3; libm: the manual of glibc, "Known Maximum Errors in Math Functions": one unit
///           in the last place, which is at most 2 u |v|, for exp log sin cos tan atan pow on x86-64 and
///           AArch64
/// Requires  R = double, Mpfr<50>
/// Result    value() has the bits that the formula has in R. bound() holds to every order, and is infinite
///           where an operand may leave the domain of the operation (a divisor may be zero, a root or
///           logarithm may reach below zero) or where v is not finite. Zero is exact, and so are products
///           with it and sums
/// Limits    comparisons are those of the values: a formula that branches on them must have the same exact
///           value on both sides, beside select_less, min, max and abs, which bound both branches. A base
///           that may be negative has no bound for pow
template <class R>
class RunningError {
public:
  /// Exactly zero.
  RunningError() = default;
  /// Exact up to 2^53.
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool>)
  RunningError(Integer n)  // NOLINT(google-explicit-constructor): exact, as in R
      : value_(static_cast<R>(n)), size_(magnitude(value_)) {}
  /// `exact` as R has rounded it to nearest.
  RunningError(const R& rounded, const Rational& exact) : RunningError(of(rounded, 0, nearest)) {
    if (exact.sign() == 0) bound_ = 0;
  }

  [[nodiscard]] static RunningError exactly(const R& value) {
    RunningError x;
    x.value_ = value;
    x.size_ = magnitude(value);
    return x;
  }
  [[nodiscard]] static RunningError pi() { return of(radcert::pi<R>(), 0, nearest); }
  /// That of R, exactly: it ends series.
  [[nodiscard]] static RunningError unit_roundoff() { return exactly(radcert::unit_roundoff<R>()); }

  [[nodiscard]] const R& value() const { return value_; }
  [[nodiscard]] double bound() const { return bound_; }
  /// At least |exact|.
  [[nodiscard]] double max_abs() const { return slack * (size_ + bound_); }
  [[nodiscard]] std::string to_text() const {
    return std::to_string(nearest_double(value_)) + " +/- " + std::to_string(bound_);
  }
  /// The same value with a larger bound.
  [[nodiscard]] RunningError widened(double by) const {
    RunningError x = *this;
    x.bound_ = finite_or_infinite(slack * (bound_ + by));
    return x;
  }

  friend bool operator==(const RunningError& a, const RunningError& b) { return a.value_ == b.value_; }
  friend std::partial_ordering operator<=>(const RunningError& a, const RunningError& b) {
    return a.value_ <=> b.value_;
  }

  RunningError operator-() const {
    RunningError x = *this;
    x.value_ = -value_;
    return x;
  }
  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    return sum(a.value_ + b.value_, a, b);
  }
  friend RunningError operator-(const RunningError& a, const RunningError& b) {
    return sum(a.value_ - b.value_, a, b);
  }
  /// A B - a b = a (B - b) + b (A - a) + (A - a)(B - b).
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    const R value = a.value_ * b.value_;
    return (a.is_zero() && b.is_bounded()) || (b.is_zero() && a.is_bounded())
               ? exactly(value)
               : of(value, product_error(a, b), nearest);
  }
  /// A/B - a/b = ((A - a) - (a/b)(B - b)) / B.
  friend RunningError operator/(const RunningError& a, const RunningError& b) {
    const R value = a.value_ / b.value_;
    const double divisor = b.least_size();
    if (!(divisor > 0)) return unbounded(value);
    if (a.is_zero()) return exactly(value);
    return of(value, (a.bound_ + a.size_ / b.size_ * b.bound_) / divisor, nearest);
  }
  friend RunningError fma(const RunningError& a, const RunningError& b, const RunningError& c) {
    using std::fma;
    return of(fma(a.value_, b.value_, c.value_), product_error(a, b) + c.bound_, nearest);
  }

  /// sqrt(A) - sqrt(a) = (A - a) / (sqrt(A) + sqrt(a)).
  friend RunningError sqrt(const RunningError& a) {
    using std::sqrt;
    const R value = sqrt(a.value_);
    if (a.is_zero()) return exactly(value);
    if (!(a.value_ > R(0) && a.least_size() >= 0)) return unbounded(value);
    return of(value, a.bound_ / (std::sqrt(a.size_) + std::sqrt(a.least_size())), nearest);
  }
  /// exp(A) - exp(a) = exp(a) (exp(A - a) - 1).
  friend RunningError exp(const RunningError& a) {
    using std::exp;
    const R value = exp(a.value_);
    return of(value, slack * magnitude(value) * std::expm1(a.bound_), function);
  }
  /// |log(A) - log(a)| <= |A - a| / min(A, a).
  friend RunningError log(const RunningError& a) {
    using std::log;
    const R value = log(a.value_);
    if (!(a.value_ > R(0) && a.least_size() > 0)) return unbounded(value);
    return of(value, a.bound_ / a.least_size(), function);
  }
  /// |sin'| <= 1.
  friend RunningError sin(const RunningError& a) {
    using std::sin;
    return of(sin(a.value_), a.bound_, function);
  }
  friend RunningError cos(const RunningError& a) {
    using std::cos;
    return of(cos(a.value_), a.bound_, function);
  }
  /// tan(A) - tan(a) = tan(A - a) (1 + tan(a)^2) / (1 - tan(a) tan(A - a)), without a pole between while the
  /// divisor is positive.
  friend RunningError tan(const RunningError& a) {
    using std::tan;
    const R value = tan(a.value_);
    const double tangent = slack * magnitude(value);
    const double of_error = a.bound_ < 1 ? std::tan(a.bound_) : infinity;
    const double divisor = 1 - roundings - slack * tangent * of_error;
    if (!(divisor > 0)) return unbounded(value);
    return of(value, of_error * (1 + tangent * tangent) / divisor, function);
  }
  /// atan' = 1/(1 + x^2), largest at the end next to zero.
  friend RunningError atan(const RunningError& a) {
    using std::atan;
    const double least = std::max(a.least_size(), 0.0);
    return of(atan(a.value_), a.bound_ / (1 + least * least), function);
  }
  /// A^B - a^b = a^b (exp(B log A - b log a) - 1), the difference of the exponents bounded as for log and the
  /// product.
  friend RunningError pow(const RunningError& a, const RunningError& b) {
    using std::pow;
    const auto value = static_cast<R>(pow(a.value_, b.value_));
    if (a.is_zero() && b.value_ > R(0) && b.least_size() > 0) return exactly(value);
    if (!(a.value_ > R(0) && a.least_size() > 0)) return unbounded(value);
    const double of_log = a.bound_ / a.least_size();
    // log of the double nearest to a: the logarithm differs by at most u, relative to a.
    const double log_size = std::abs(std::log(nearest_double(a.value_))) + roundings;
    const double of_exponent = b.size_ * of_log + log_size * b.bound_ + of_log * b.bound_;
    return of(value, slack * magnitude(value) * std::expm1(slack * of_exponent), function);
  }

  /// ||A| - |a|| <= |A - a|.
  friend RunningError abs(const RunningError& a) {
    using std::abs;
    RunningError x = a;
    x.value_ = abs(a.value_);
    return x;
  }
  friend RunningError min(const RunningError& a, const RunningError& b) {
    const bool first = !(b.value_ < a.value_);
    return one_of(smaller_of(a.value_, b.value_), first ? a : b, first ? b : a);
  }
  friend RunningError max(const RunningError& a, const RunningError& b) {
    const bool first = !(a.value_ < b.value_);
    return one_of(larger_of(a.value_, b.value_), first ? a : b, first ? b : a);
  }
  /// The branch that the values take; where the exact ones may take the other, both are bounded.
  friend RunningError select_less(const RunningError& a, const RunningError& b, const RunningError& if_less,
                                  const RunningError& otherwise) {
    const bool less = a.value_ < b.value_;
    const RunningError& taken = less ? if_less : otherwise;
    const RunningError& left = less ? otherwise : if_less;
    if (gap(a, b) > a.bound_ + b.bound_) return taken;
    return taken.widened(slack * magnitude(taken.value_ - left.value_) + left.bound_);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// No bound here takes more than 30 operations on doubles, each of which may round down by 2^-53, or 2^-52
  /// in libm.
  static constexpr double roundings = 0x1p-47;
  static constexpr double slack = 1 + roundings;
  /// Below, products of doubles, u |v| among them, may lose digits to underflow, by less than the smallest
  /// normal number; so may the operation itself.
  static constexpr double may_underflow = 0x1p-800;
  inline static const double unit = nearest_double(radcert::unit_roundoff<R>());
  static constexpr double nearest = 1;
  static constexpr double function = std::floating_point<R> ? 2 : 1;

  static double magnitude(const R& x) { return std::abs(nearest_double(x)); }
  static double finite_or_infinite(double bound) {
    return bound <= std::numeric_limits<double>::max() ? bound : infinity;
  }

  static RunningError unbounded(const R& value) {
    RunningError x = exactly(value);
    x.bound_ = infinity;
    return x;
  }
  /// The value of an operation, what its operands' errors have done to it, and its own rounding in units.
  static RunningError of(const R& value, double propagated, double units) {
    RunningError x = exactly(value);
    const double bound = slack * (propagated + units * unit * x.size_);
    x.bound_ = finite_or_infinite(bound < may_underflow ? bound + std::numeric_limits<double>::min() : bound);
    return x;
  }
  static RunningError sum(const R& value, const RunningError& a, const RunningError& b) {
    if (a.is_zero() || b.is_zero()) {
      RunningError x = exactly(value);
      x.bound_ = a.bound_ + b.bound_;
      return x;
    }
    const RunningError x = of(value, a.bound_ + b.bound_, nearest);
    return x.size_ == 0 && value == R(0) ? exactly(value).widened(a.bound_ + b.bound_) : x;
  }
  static double product_error(const RunningError& a, const RunningError& b) {
    return a.size_ * b.bound_ + b.size_ * a.bound_ + a.bound_ * b.bound_;
  }
  /// min or max: the exact value is at most the other's error, less what lies between them, off the value
  /// taken.
  static RunningError one_of(const R& value, const RunningError& taken, const RunningError& left) {
    RunningError x = exactly(value);
    x.bound_ = finite_or_infinite(std::max(taken.bound_, slack * (left.bound_ - gap(taken, left))));
    if (!left.is_bounded()) x.bound_ = infinity;
    return x;
  }
  /// At most |a - b|.
  static double gap(const RunningError& a, const RunningError& b) {
    return (1 - roundings) * magnitude(a.value_ - b.value_);
  }

  bool is_zero() const { return bound_ == 0 && size_ == 0 && value_ == R(0); }
  bool is_bounded() const { return bound_ < infinity && size_ < infinity; }
  /// At most |exact|; zero or less where that may be zero.
  double least_size() const { return (1 - roundings) * size_ - slack * bound_; }

  R value_{};
  double size_ = 0;  ///< the double nearest to |value|
  double bound_ = 0;
};

/// phi[a,a,b] for phi(x) = x^e, b = a + d: the steps of DividedDifference, and what is left out of the
/// series.
/// Maths     the terms t_k of the binomial series have t_(k+1) = t_k x (e - k)/(k + 1), x = d/a: from k >=
///           (e-1)/2 on they fall at least as fast as the powers of x, so that the rest after t_k is at most
///           |t_k| |x| / (1 - |x|)
/// Source    as DividedDifference
/// Requires  as DividedDifference
/// Result    the value has the bits of R; no bound where e or |x| is too large for the rest to be bounded
template <class R>
RunningError<R> bend_with_remainder(const RunningError<R>& a, const RunningError<R>& b,
                                    const RunningError<R>& d, const Exponent<RunningError<R>>& e) {
  using Number = RunningError<R>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a == Number(0) && d == Number(0))  // a value for a constant alone
    return Number(0).widened(a.bound() == 0 && d.bound() == 0 ? 0 : infinity);
  if (!(abs(d + d) <= a))
    return (power(b, e) - power(a, e) - e.value() * power(a, e.minus_one()) * d) / (d * d);
  const Number x = d / a;
  Number term = e.value() * (e.value() - Number(1)) / Number(2);
  Number sum = term;
  int k = 2;
  for (; abs(term) > unit_roundoff<Number>() * abs(sum); ++k) {
    term = term * x * (e.value() - Number(k)) / Number(k + 1);
    sum = sum + term;
  }
  const double ratio = x.max_abs();
  const bool falls = ratio < 0.75 && nearest_double(e.value().value()) <= 2 * k;
  const double rest = falls ? term.max_abs() * ratio / (1 - ratio) : infinity;
  return sum.widened(rest) * power(a, e.minus_one()) / a;
}

}  // namespace radcert::laws

namespace radcert {

template <class R>
struct Constants<laws::RunningError<R>> {
  static laws::RunningError<R> from_rational(const Rational& q) { return {radcert::from_rational<R>(q), q}; }
  static laws::RunningError<R> pi() { return laws::RunningError<R>::pi(); }
};

template <>
inline laws::RunningError<double> DividedDifference<laws::RunningError<double>>::bend_in_one_lane(
    const laws::RunningError<double>& a, const laws::RunningError<double>& b,
    const laws::RunningError<double>& d, const Exponent<laws::RunningError<double>>& e) {
  return laws::bend_with_remainder(a, b, d, e);
}
template <>
inline laws::RunningError<Mpfr<50>> DividedDifference<laws::RunningError<Mpfr<50>>>::bend_in_one_lane(
    const laws::RunningError<Mpfr<50>>& a, const laws::RunningError<Mpfr<50>>& b,
    const laws::RunningError<Mpfr<50>>& d, const Exponent<laws::RunningError<Mpfr<50>>>& e) {
  return laws::bend_with_remainder(a, b, d, e);
}

}  // namespace radcert
