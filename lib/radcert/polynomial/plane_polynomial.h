// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A polynomial of two variables by its monomials.
/// Maths     q(s,t) = sum_{i+j <= degree} c_ij s^i t^j
/// Requires  degree >= 0
/// Result    coefficients by total degree, then by j: c_00; c_10, c_01; c_20, c_11, c_02; ...; all zero at
///           first
/// Limits    monomials: for closed forms and exact work; the pipeline evaluates InsetBasis
template <Field R>
class PlanePolynomial {
public:
  explicit PlanePolynomial(int degree = 0) : degree_(degree) {
    expects(degree >= 0, "degree >= 0", named("degree", degree));
    coefficients_.assign(size_of(degree), R(0));
  }

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] const std::vector<R>& coefficients() const { return coefficients_; }
  /// c_ij.
  [[nodiscard]] R& operator()(int i, int j) { return coefficients_[place(i, j)]; }
  [[nodiscard]] const R& operator()(int i, int j) const { return coefficients_[place(i, j)]; }

  /// q(s,t), by Horner's rule in either variable.
  template <Field T>
  [[nodiscard]] T value(const T& s, const T& t) const {
    T sum = T(0);
    for (int i = degree_; i >= 0; --i) {
      T inner = T(0);
      for (int j = degree_ - i; j >= 0; --j) inner = inner * t + T((*this)(i, j));
      sum = sum * s + inner;
    }
    return sum;
  }

  /// The place of s^i t^j among the coefficients, and how many there are up to a degree.
  [[nodiscard]] static std::size_t place(int i, int j) {
    expects(i >= 0 && j >= 0, "exponents >= 0", named("i", i), named("j", j));
    return size_of(i + j - 1) + static_cast<std::size_t>(j);
  }
  [[nodiscard]] static std::size_t size_of(int degree) {
    return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
  }

private:
  int degree_;
  std::vector<R> coefficients_;
};

/// A constant as a polynomial of degree 0.
template <Field R>
[[nodiscard]] PlanePolynomial<R> constant_polynomial(const R& value) {
  PlanePolynomial<R> out(0);
  out(0, 0) = value;
  return out;
}

}  // namespace radcert
