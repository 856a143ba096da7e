// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "radcert/scalar/bounded_double.h"

namespace radcert {

/// The Taylor coefficients of a function of one variable at all points of an interval, enclosed.
/// Maths     c_k encloses f^(k)(y) / k! for every y of an interval, k = 0, ..., degree
/// Source    automatic differentiation: R. E. Moore, Interval Analysis, 1966, chapter 11; A. Griewank, A.
///           Walther, Evaluating Derivatives, 2008, chapter 13. From c' = a' / a for the logarithm and c' = a' /
///           (1 + a^2) for the arc tangent, coefficient by coefficient
/// Requires  variable(): an interval as a BoundedDouble
/// Result    enclosures, rounding within; infinite or no number where a divisor, a radicand or the argument of
///           a logarithm may vanish on the interval
template <int degree>
class TaylorSeries {
public:
  static constexpr std::size_t count = degree + 1;

  TaylorSeries() = default;
  TaylorSeries(const BoundedDouble& constant) {  // NOLINT(google-explicit-constructor): the same number
    c_[0] = constant;
    used_ = 1;
  }
  /// centre + slope y, y in the interval.
  static TaylorSeries linear(const BoundedDouble& constant, const BoundedDouble& slope,
                             const BoundedDouble& interval) {
    TaylorSeries out(constant + slope * interval);
    out.c_[1] = slope;
    out.used_ = 2;
    return out;
  }
  [[nodiscard]] const BoundedDouble& operator[](std::size_t k) const { return c_[k]; }

  TaylorSeries operator-() const {
    TaylorSeries out = *this;
    for (std::size_t k = 0; k < used_; ++k) out.c_[k] = -c_[k];
    return out;
  }
  friend TaylorSeries operator+(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    out.used_ = std::max(a.used_, b.used_);
    for (std::size_t k = 0; k < out.used_; ++k) out.c_[k] = a.c_[k] + b.c_[k];
    return out;
  }
  friend TaylorSeries operator-(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    out.used_ = std::max(a.used_, b.used_);
    for (std::size_t k = 0; k < out.used_; ++k) out.c_[k] = a.c_[k] - b.c_[k];
    return out;
  }
  friend TaylorSeries operator*(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    if (a.used_ == 0 || b.used_ == 0) return out;
    out.used_ = std::min(count, a.used_ + b.used_ - 1);
    for (std::size_t i = 0; i < a.used_; ++i)
      for (std::size_t j = 0; j < b.used_ && i + j < count; ++j)
        out.c_[i + j] = out.c_[i + j] + a.c_[i] * b.c_[j];
    return out;
  }
  friend TaylorSeries operator/(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    out.used_ = count;
    for (std::size_t k = 0; k < count; ++k) {
      BoundedDouble rest = a.c_[k];
      for (std::size_t j = 1; j <= k && j < b.used_; ++j) rest = rest - b.c_[j] * out.c_[k - j];
      out.c_[k] = rest / b.c_[0];
    }
    return out;
  }
  friend TaylorSeries sqrt(const TaylorSeries& a) {
    TaylorSeries out;
    out.used_ = count;
    out.c_[0] = sqrt(a.c_[0]);
    const BoundedDouble twice = out.c_[0] + out.c_[0];
    for (std::size_t k = 1; k < count; ++k) {
      BoundedDouble rest = a.c_[k];
      for (std::size_t j = 1; j < k; ++j) rest = rest - out.c_[j] * out.c_[k - j];
      out.c_[k] = rest / twice;
    }
    return out;
  }
  friend TaylorSeries log(const TaylorSeries& a) { return primitive(log(a.c_[0]), a, a); }
  friend TaylorSeries atan(const TaylorSeries& a) {
    return primitive(atan(a.c_[0]), a, TaylorSeries(BoundedDouble(1)) + a * a);
  }

private:
  /// c_0, and c' = a' / d: k c_k d_0 = k a_k - sum of j c_j d_(k-j), 0 < j < k.
  static TaylorSeries primitive(const BoundedDouble& first, const TaylorSeries& a, const TaylorSeries& d) {
    TaylorSeries out;
    out.used_ = count;
    out.c_[0] = first;
    for (std::size_t k = 1; k < count; ++k) {
      BoundedDouble rest = whole(k) * a.c_[k];
      for (std::size_t j = 1; j < k; ++j) rest = rest - whole(j) * (out.c_[j] * d.c_[k - j]);
      out.c_[k] = rest / (whole(k) * d.c_[0]);
    }
    return out;
  }
  static BoundedDouble whole(std::size_t k) { return static_cast<int>(k); }

  std::array<BoundedDouble, count> c_{};
  std::size_t used_ = 0;  ///< those beyond are exactly 0
};

}  // namespace radcert
