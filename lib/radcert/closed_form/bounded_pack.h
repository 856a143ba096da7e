// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

#include "radcert/scalar/pack_functions.h"

namespace radcert {

/// Eight doubles that carry bounds of their errors.
/// Maths     BoundedDouble, lane by lane
/// Source    BoundedDouble
/// Requires  no operation underflows
/// Result    the bound holds to all orders, in formulas of fewer than 2^20 operations; where nothing can be said, division by what may be 0, log of what
///           may be negative, an angle across the cut, it is `unknown` or larger
/// Limits    that bound is a large number, so that no lane becomes something that is no number
class BoundedPack {
public:
  static constexpr double unknown = 0x1p500;
  /// The roundoff of one operation, and a little for those of the bounds themselves.
  static constexpr double unit = 0x1.04p-53;

  BoundedPack() = default;
  template <std::signed_integral Integer>
  BoundedPack(Integer value)  // NOLINT(google-explicit-constructor): exact for the small numbers of a formula
      : value_(static_cast<double>(value)), error_(0.0) {}
  BoundedPack(const Pack& value, const Pack& error) : value_(value), error_(error) {}
  static BoundedPack exactly(const Pack& value) { return {value, Pack(0)}; }
  /// Values that were rounded that often.
  static BoundedPack rounded(const Pack& value, double times = 1) {
    return {value, Pack(times * unit) * abs(value)};
  }

  [[nodiscard]] const Pack& value() const { return value_; }
  /// With room for the roundings of the bound itself, of which an operation has fewer than eight, of one part in 2^53 each.
  [[nodiscard]] Pack error() const { return Pack(1 + 0x1p-30) * error_; }
  /// At most the size of the exact number; 0 if that may be 0.
  [[nodiscard]] Pack smallest_size() const { return max(Pack(0), abs(value_) - error()); }

  BoundedPack operator-() const { return {-value_, error_}; }
  friend BoundedPack operator+(const BoundedPack& a, const BoundedPack& b) {
    return own(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend BoundedPack operator-(const BoundedPack& a, const BoundedPack& b) {
    return own(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend BoundedPack operator*(const BoundedPack& a, const BoundedPack& b) {
    return own(a.value_ * b.value_, fused(abs(a.value_), b.error_, a.error_ * (abs(b.value_) + b.error_)));
  }
  friend BoundedPack operator/(const BoundedPack& a, const BoundedPack& b) {
    const Pack least = b.smallest_size();
    const PackMask divides = less(Pack(0), least);
    const Pack quotient = a.value_ / select(divides, b.value_, Pack(1));
    const Pack passed = fused(abs(quotient), b.error_, a.error_) / select(divides, least, Pack(1));
    return own(quotient, select(divides, passed, Pack(unknown)));
  }
  friend BoundedPack sqrt(const BoundedPack& a) {
    const Pack least = a.value_ - a.error();
    const PackMask positive = less(Pack(0), least);
    // |sqrt(a) - sqrt(b)| = |a - b| / (sqrt(a) + sqrt(b)), and sqrt(least) >= least / root
    const Pack inside = select(positive, a.value_, Pack(1));
    const Pack root = sqrt(inside);
    const Pack passed = Pack(slack) * a.error_ * root / (inside + select(positive, least, Pack(1)));
    return own(root, select(positive, passed, Pack(unknown)));
  }
  friend BoundedPack log(const BoundedPack& a) {
    const Pack least = a.value_ - a.error();
    const PackMask positive = less(Pack(smallest), least);
    const Pack value = fast_log(select(positive, a.value_, Pack(1)));
    const Pack passed = a.error_ / select(positive, least, Pack(1));
    return {value, select(positive, passed, Pack(unknown)) + Pack(log_roundings * unit) * abs(value)};
  }
  /// The angle of (x, y) in (-pi, pi].
  friend BoundedPack atan2(const BoundedPack& y, const BoundedPack& x) {
    const Pack size = abs(x.value_) + abs(y.value_);
    const Pack moved = x.error_ + y.error_;
    // Beyond that the first order does not bound the change; the ray to the left is where the angle jumps.
    const PackMask jumps = at_most(x.value_, x.error_) & at_most(abs(y.value_), y.error_);
    const PackMask known = less(Pack(64) * moved, size) & !jumps;
    const Pack value = fast_atan2(select(known, y.value_, Pack(0)), select(known, x.value_, Pack(1)));
    // On the segment to the exact point the distance from the origin is at least (1 - sqrt(2)/64) of its
    // value here.
    const Pack squared = fused(x.value_, x.value_, y.value_ * y.value_);
    const Pack passed = fused(abs(x.value_) + moved, y.error_, (abs(y.value_) + moved) * x.error_);
    const Pack error = Pack(nearer) * passed / select(known, squared, Pack(1));
    return {value, select(known, error, Pack(unknown)) + Pack(angle_roundings * unit) * abs(value)};
  }
  /// The same for p, q >= 0, not both zero, of which p / q has the relative error `relative`.
  static BoundedPack acute(const AcuteAngles& angles, const Pack& relative) {
    const Pack& angle = angles.of_first;
    // The angle moves by half the relative error of its tangent at most, and by less than that part of
    // itself.
    const Pack passed = Pack(nearer) * relative * min(Pack(0.5), angle);
    return {angle, min(angles.error, Pack(acute_roundings * unit) * angle) + passed};
  }
  friend BoundedPack select(const PackMask& mask, const BoundedPack& yes, const BoundedPack& no) {
    return {select(mask, yes.value_, no.value_), select(mask, yes.error_, no.error_)};
  }

  static constexpr double log_roundings = 4.1;  ///< of fast_log
  static constexpr double angle_roundings = 7;  ///< of fast_atan2
  static constexpr double acute_roundings = 6;  ///< of acute_angles

private:
  static constexpr double slack = 1.02;
  static constexpr double nearer = 1.06;
  static constexpr double smallest = 0x1p-1000;

  static BoundedPack own(const Pack& value, const Pack& passed) {
    return {value, fused(Pack(unit), abs(value), passed)};
  }

  Pack value_;
  Pack error_;
};

}  // namespace radcert
