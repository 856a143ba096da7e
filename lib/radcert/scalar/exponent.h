// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A constant real exponent that remembers whether it is a whole number.
/// Maths     x -> x^p, p >= 0 constant; a whole p is a product and has no logarithm in it
/// Source    the profile z = 2 - x^p of [ac98, (94)]
/// Requires  p >= 0, and |p| < 10^6 if whole; else ContractViolation
/// Result    whole p: repeated multiplication; otherwise pow of the arithmetic R
/// Limits    the base is >= 0
template <Field R>
class Exponent {
public:
  explicit Exponent(const Rational& p) : value_(from_rational<R>(p)), whole_(p.is_integer()), count_(0) {
    expects(p >= Rational(0), "p >= 0", named("p", p.to_text()));
    if (!whole_) return;
    expects(p < Rational(1000000), "a whole exponent below 10^6", named("p", p.to_text()));
    count_ = static_cast<long>(p.to_double());
  }

  const R& value() const { return value_; }
  bool is_whole() const { return whole_; }
  long whole() const { return count_; }

  /// p - 1, for p >= 1.
  Exponent minus_one() const { return Exponent(value_ - R(1), whole_, count_ - 1); }
  /// The same exponent in the arithmetic of a single lane of R.
  template <class Lane>
  Exponent<Lane> in(const Lane& value) const {
    return Exponent<Lane>(value, whole_, count_);
  }

  friend R power(const R& x, const Exponent& p) {
    using std::pow;
    return p.whole_ ? power(x, p.count_) : static_cast<R>(pow(x, p.value_));
  }

private:
  template <Field>
  friend class Exponent;
  Exponent(const R& value, bool whole, long count) : value_(value), whole_(whole), count_(count) {}
  R value_;
  bool whole_;
  long count_;
};

}  // namespace radcert
