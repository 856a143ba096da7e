// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "radcert/scalar/bounded_double.h"

namespace radcert {

/// The Taylor coefficients of a function of one variable at all points of an interval, enclosed.
/// Maths     c_k encloses f^(k)(y) / k! for every y of an interval, k = 0, ..., degree
/// Source    automatic differentiation: R. E. Moore, Interval Analysis, 1966, chapter 11; A. Griewank, A.
///           Walther, Evaluating Derivatives, 2008, chapter 13. From c' = a' / a for the logarithm and
///           c' = a' / (1 + a^2) for the arc tangent, coefficient by coefficient
/// Result    enclosures, rounding within; infinite or no number where a divisor, a radicand or the argument
///           of a logarithm may vanish on the interval
template <int degree>
class TaylorSeries {
public:
  static constexpr std::size_t count = degree + 1;

  TaylorSeries() = default;
  TaylorSeries(const BoundedDouble& constant) {  // NOLINT(google-explicit-constructor): the same number
    c_[0] = constant;
    used_ = 1;
  }
  /// constant + slope y at y = 0.
  static TaylorSeries linear(const BoundedDouble& constant, const BoundedDouble& slope) {
    TaylorSeries out(constant);
    out.c_[1] = slope;
    out.used_ = 2;
    return out;
  }
  /// For a polynomial whose coefficients at y = 0 these are: those at all y of [-1, 1].
  /// Maths     p^(k)(y) / k! = sum over j >= k of binomial(j, k) c_j y^(j-k)
  [[nodiscard]] TaylorSeries everywhere() const {
    TaylorSeries out;
    out.used_ = used_;
    for (std::size_t k = 0; k < used_; ++k) {
      double away = 0;
      double binomial = 1;
      for (std::size_t j = k + 1; j < used_; ++j) {
        binomial = binomial * static_cast<double>(j) / static_cast<double>(j - k);
        away += binomial * (std::abs(c_[j].value()) + c_[j].error());
      }
      // Fewer than 64 roundings.
      out.c_[k] = {c_[k].value(), (c_[k].error() + away) * (1 + 0x1p-46)};
    }
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
    const Sizes left(a);
    const Sizes right(b);
    for (std::size_t k = 0; k < out.used_; ++k) {
      const std::size_t first = k < b.used_ ? 0 : k - b.used_ + 1;
      out.c_[k] = sum_of_products(left, right, first, std::min(k + 1, a.used_), k);
    }
    return out;
  }
  friend TaylorSeries operator/(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    out.used_ = count;
    const Sizes divisor(b);
    Sizes quotient;
    for (std::size_t k = 0; k < count; ++k) {
      BoundedDouble rest = a.c_[k];
      if (k > 0) rest = rest - sum_of_products(divisor, quotient, 1, std::min(k + 1, b.used_), k);
      out.c_[k] = rest / b.c_[0];
      quotient.set(k, out.c_[k]);
    }
    return out;
  }
  friend TaylorSeries sqrt(const TaylorSeries& a) {
    TaylorSeries out;
    out.used_ = count;
    out.c_[0] = sqrt(a.c_[0]);
    const BoundedDouble twice = out.c_[0] + out.c_[0];
    Sizes root;
    for (std::size_t k = 1; k < count; ++k) {
      BoundedDouble rest = a.c_[k];
      if (k > 1) rest = rest - sum_of_products(root, root, 1, k, k);
      out.c_[k] = rest / twice;
      root.set(k, out.c_[k]);
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
    const Sizes divisor(d);
    Sizes derivative;  // j c_j
    for (std::size_t k = 1; k < count; ++k) {
      BoundedDouble rest = whole(k) * a.c_[k];
      if (k > 1) rest = rest - sum_of_products(derivative, divisor, 1, k, k);
      const BoundedDouble times = rest / d.c_[0];
      derivative.set(k, times);
      out.c_[k] = times / whole(k);
    }
    return out;
  }
  static BoundedDouble whole(std::size_t k) { return static_cast<int>(k); }

  /// Values and errors apart, for loops over them.
  struct Sizes {
    Sizes() = default;
    explicit Sizes(const TaylorSeries& a) {
      for (std::size_t k = 0; k < a.used_; ++k) set(k, a.c_[k]);
    }
    void set(std::size_t k, const BoundedDouble& x) {
      value[k] = x.value();
      error[k] = x.error();
    }
    std::array<double, count> value{};
    std::array<double, count> error{};
  };

  /// The sum of a_i b_(k-i), first <= i < last.
  /// Proof     |a b - a' b'| <= |a| e_b + e_a (|b| + e_b) for values a, b and the exact a', b'; rounding of n
  ///           <= 16 products and their sum is at most n 2^-53 (1 + 2^-40) of the sum of the products' sizes,
  ///           and of their bounds less than 2^-45 of these. Products that underflow lose less than 1e-300
  static BoundedDouble sum_of_products(const Sizes& a, const Sizes& b, std::size_t first, std::size_t last,
                                       std::size_t k) {
    static_assert(count <= 16);
    double value = 0;
    double error = 0;
    double size = 0;
    for (std::size_t i = first; i < last; ++i) {
      const double x = a.value[i];
      const double y = b.value[k - i];
      const double absolute = std::abs(y);
      value += x * y;
      size += std::abs(x) * absolute;
      error += std::abs(x) * b.error[k - i] + a.error[i] * (absolute + b.error[k - i]);
    }
    return {value, error * (1 + 0x1p-45) + size * 0x1.1p-49 + 1e-300};
  }

  std::array<BoundedDouble, count> c_{};
  std::size_t used_ = 0;  ///< those beyond are exactly 0
};

}  // namespace radcert
