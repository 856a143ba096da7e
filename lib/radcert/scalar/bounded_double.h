// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>

#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The larger of two bounds.
/// Result    infinite where one of them is no number: nothing is known then, nor of any maximum with it
constexpr double larger_bound(double a, double b) {
  return a < b ? b : (b <= a ? a : std::numeric_limits<double>::infinity());
}

/// A double that carries a bound of its error.
/// Maths     |exact - value| <= error; an operation adds what it passes on from its operands and its own
///           rounding
/// Source    running error analysis: Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms, 2002,
///           3.3
/// Requires  the C library's exp, log, sin, cos, atan and atan2 are within two units in the last place
/// Result    the bound holds, to all orders; it is infinite, or no number, where nothing can be said:
///           division by what may be 0, log of what may be negative, an angle across the cut
/// Limits    a bound beside a double, for sums of a few dozen terms at a few times the price: no Real, and no
///           Ball
class BoundedDouble {
public:
  BoundedDouble() = default;
  template <std::signed_integral Integer>
  BoundedDouble(
      Integer value)  // NOLINT(google-explicit-constructor): exact for the small numbers of a formula
      : value_(static_cast<double>(value)) {}
  BoundedDouble(double value, double error) : value_(value), error_(error) {}
  static BoundedDouble exactly(double value) { return {value, 0}; }
  /// A value that was rounded once.
  static BoundedDouble rounded(double value) { return {value, unit * std::abs(value) + underflow}; }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double error() const { return error_; }
  /// At most the size of the exact number; 0 if that may be 0.
  [[nodiscard]] double smallest_size() const {
    return std::max(0.0, (std::abs(value_) - error_) * rounded_down);
  }

  BoundedDouble operator-() const { return {-value_, error_}; }
  friend BoundedDouble operator+(const BoundedDouble& a, const BoundedDouble& b) {
    return own(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend BoundedDouble operator-(const BoundedDouble& a, const BoundedDouble& b) {
    return own(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend BoundedDouble operator*(const BoundedDouble& a, const BoundedDouble& b) {
    return own(a.value_ * b.value_,
               std::abs(a.value_) * b.error_ + a.error_ * (std::abs(b.value_) + b.error_) + underflow);
  }
  friend BoundedDouble operator/(const BoundedDouble& a, const BoundedDouble& b) {
    const double least = std::abs(b.value_) - b.error_;
    if (!(least > 0)) return unknown();
    const double quotient = a.value_ / b.value_;
    // What the product in the numerator may lose is divided as well.
    return own(quotient, (a.error_ + (std::abs(quotient) * b.error_ + lost)) / least + underflow);
  }
  friend BoundedDouble sqrt(const BoundedDouble& a) {
    const double least = a.value_ - a.error_;
    if (!(least > 0)) return unknown();
    // |sqrt(a) - sqrt(b)| = |a - b| / (sqrt(a) + sqrt(b)), and sqrt(least) >= least / root
    const double root = std::sqrt(a.value_);
    return own(root, slack * a.error_ / (root + least / root) + underflow);
  }
  friend BoundedDouble log(const BoundedDouble& a) {
    const double least = a.value_ - a.error_;
    if (!(least > 0)) return unknown();
    const double value = std::log(a.value_);
    return {value, a.error_ / least * rounded_up + library * std::abs(value) + underflow};
  }
  friend BoundedDouble exp(const BoundedDouble& a) {
    if (!(a.error_ < 1)) return unknown();
    const double value = std::exp(a.value_);
    // e^d - 1 <= d + d^2
    return {value, (value * (a.error_ + a.error_ * a.error_) + library * value) * slack + underflow};
  }
  friend BoundedDouble sin(const BoundedDouble& a) {
    const double value = std::sin(a.value_);
    return {value, a.error_ * rounded_up + library * std::abs(value) + underflow};
  }
  friend BoundedDouble cos(const BoundedDouble& a) {
    const double value = std::cos(a.value_);
    return {value, a.error_ * rounded_up + library * std::abs(value) + underflow};
  }
  friend BoundedDouble tan(const BoundedDouble& a) { return sin(a) / cos(a); }
  /// a > 0.
  friend BoundedDouble pow(const BoundedDouble& a, const BoundedDouble& b) { return exp(b * log(a)); }
  friend BoundedDouble abs(const BoundedDouble& a) { return {std::abs(a.value_), a.error_}; }
  friend BoundedDouble atan(const BoundedDouble& a) {
    const double value = std::atan(a.value_);
    const double least = std::max(0.0, std::abs(a.value_) - a.error_);
    return {value, a.error_ / (1 + least * least) * slack + library * std::abs(value) + underflow};
  }
  /// The angle of (x, y) in (-pi, pi].
  friend BoundedDouble atan2(const BoundedDouble& y, const BoundedDouble& x) {
    const double size = std::abs(x.value_) + std::abs(y.value_);
    const double moved = x.error_ + y.error_;
    // Beyond that the first order does not bound the change; the ray to the left is where the angle jumps.
    const bool jumps = x.value_ - x.error_ <= 0 && std::abs(y.value_) <= y.error_;
    if (!(moved < size / 64) || !(size > smallest_point && size < largest_point) || jumps) return unknown();
    const double value = std::atan2(y.value_, x.value_);
    // On the segment to the exact point the distance from the origin is at least (1 - sqrt(2)/64) of its
    // value here.
    const double squared = x.value_ * x.value_ + y.value_ * y.value_;
    const double nearer = 1.06 / squared;
    const double passed = ((std::abs(x.value_) + moved) * nearer) * y.error_ +
                          ((std::abs(y.value_) + moved) * nearer) * x.error_;
    return {value, passed + library * std::abs(value) + underflow};
  }
  friend bool certainly_zero(const BoundedDouble& a) { return a.value_ == 0 && a.error_ == 0; }
  friend BoundedDouble min(const BoundedDouble& a, const BoundedDouble& b) {
    return {std::min(a.value_, b.value_), larger_bound(a.error_, b.error_)};
  }
  friend BoundedDouble max(const BoundedDouble& a, const BoundedDouble& b) {
    return {std::max(a.value_, b.value_), larger_bound(a.error_, b.error_)};
  }
  /// radius >= 0 and at most 1 exactly; |angle| <= pi.
  friend BoundedDouble dilogarithm_imaginary(const BoundedDouble& radius, const BoundedDouble& angle) {
    if (!(radius.error_ < 1 && angle.error_ < 1)) return unknown();
    const double inside = std::clamp(radius.value_, 0.0, 1.0);
    const double value = dilogarithm_imaginary(inside, angle.value_);
    // The derivatives: at most pi/2 along the radius, and -log|1 - z| along the angle, where
    // |1 - z|^2 = (1 - r)^2 + 4 r sin^2(phi/2) >= (1 - r)^2 + 4 r (phi / pi)^2. Within the error of the
    // singularity the mean of the logarithm over d is 1 + log(pi/d).
    const double gap = std::max(0.0, 1 - inside - radius.error_);
    const double turn = std::max(0.0, std::abs(angle.value_) - angle.error_);
    const double squared = std::max(gap * gap + 0.4 * std::max(0.0, inside - radius.error_) * turn * turn,
                                    angle.error_ * angle.error_ / 16);
    const double bits = squared > 0 ? std::max(2, 1 - std::ilogb(squared)) : 0;
    const double slope = 1 + 0.3466 * bits;  // log(2) / 2 a bit
    return {value, 1.5708 * radius.error_ + slope * angle.error_ + 6 * 2 * unit * std::abs(value)};
  }

private:
  /// The roundoff of one operation, and a little for those of the bounds themselves.
  static constexpr double unit = 0x1.04p-53;
  static constexpr double library = 4 * unit;
  static constexpr double slack = 1.02;
  /// More than the roundings of what is passed on: fewer than eight.
  static constexpr double rounded_up = 1 + 0x1p-50;
  /// Less than 1 - 2^-53, which the difference of value and error may gain by its rounding.
  static constexpr double rounded_down = 1 - 0x1p-51;
  /// Far more than what a product, and the products in its bound, may lose by underflow; a product alone
  /// loses less than `lost`.
  static constexpr double underflow = 1e-290;
  static constexpr double lost = 1e-323;
  /// Points whose squared distance from the origin is a normal number.
  static constexpr double smallest_point = 1e-140;
  static constexpr double largest_point = 1e140;

  static BoundedDouble own(double value, double passed) {
    return {value, passed * rounded_up + unit * std::abs(value)};
  }
  static BoundedDouble unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  double value_ = 0;
  double error_ = 0;
};

/// Numbers as they enter doubles with a bound: rounded, the bound holds that.
template <>
struct Constants<BoundedDouble> {
  static BoundedDouble from_rational(const Rational& q) {
    // Whole numbers are frequent, and cheap.
    constexpr long largest = 1L << 53U;
    if (const std::optional<long> whole = q.to_long(); whole && -largest <= *whole && *whole <= largest)
      return *whole;
    const double value = q.to_double();
    return Rational::exactly(value) == q ? BoundedDouble::exactly(value) : BoundedDouble::rounded(value);
  }
  static BoundedDouble pi() { return BoundedDouble::rounded(std::numbers::pi); }
};

}  // namespace radcert
