// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"

namespace radcert {

/// P_0(x), ..., P_n(x) for n + 1 = values.size().
/// Maths     (i+1) P_(i+1) = (2i+1) x P_i - i P_(i-1)
/// Result    for |x| <= 1, off by at most 8 (i+1)^2 u: a step passes on at most twice the error of the last,
///           whose growth is that of the second solution, bounded by i+1 on [-1,1]
template <class R>
void legendre_values(const R& x, std::span<R> values) {
  values[0] = R(1);
  if (values.size() > 1) values[1] = x;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const auto k = static_cast<double>(i);
    values[i + 1] = (R(2 * k + 1) * x * values[i] - R(k) * values[i - 1]) / R(k + 1);
  }
}

/// Several functions that are polynomials on each element.
/// Maths     f_k(s,t) = sum_(i,j <= degree) c_kij P_i(x) P_j(y) on an element with the box [s0,s1] x [t0,t1],
///           x = (2s - s0 - s1)/(s1 - s0), y alike
/// Result    coefficients by element, function, i, j; the function is exact: its coefficients are doubles
class SectorFunctions {
public:
  SectorFunctions(std::size_t elements, std::size_t count, int degree)
      : count_(count), degree_(degree), coefficients_(elements * count * size()) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int degree() const { return degree_; }
  /// Of one function on one element.
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(degree_ + 1) * static_cast<std::size_t>(degree_ + 1);
  }
  [[nodiscard]] std::span<double> of(std::size_t element, std::size_t k) {
    return {coefficients_.data() + (element * count_ + k) * size(), size()};
  }
  [[nodiscard]] std::span<const double> of(std::size_t element, std::size_t k) const {
    return {coefficients_.data() + (element * count_ + k) * size(), size()};
  }
  [[nodiscard]] std::span<double> all() { return coefficients_; }
  [[nodiscard]] std::span<const double> all() const { return coefficients_; }

private:
  std::size_t count_;
  int degree_;
  std::vector<double> coefficients_;
};

/// What bounds a function of SectorFunctions around an element, by the powers of either variable.
/// Maths     by_s[i] = sum_j |c_ij|, by_t[j] = sum_i |c_ij|, the largest over the functions that are asked
///           for. |P_i(z)| <= rho^i in the ellipse with the foci -1, 1 and half axes summing to rho
///           (Laplace's integral), so that |f| <= sum_i by_s[i] rho^i for x there and y real
struct PolynomialSizes {
  std::vector<double> by_s;
  std::vector<double> by_t;
};

/// sum_i sizes[i] rho^i, rounded up.
[[nodiscard]] inline double size_in_ellipse(std::span<const double> sizes, double rho) {
  double sum = 0;
  for (std::size_t i = sizes.size(); i-- > 0;) sum = sum * rho + sizes[i];
  return sum * (1 + 1e-12);
}

/// The sum of the half axes of an ellipse with foci -1, 1 that holds the one about a part of the interval.
/// Maths     z = m + h w, |m| + h <= 1, w in the ellipse with foci -1, 1 and the larger half axis a: |z-1| <=
///           1 - m - h + h |w-1|, |z+1| <= 1 + m - h + h |w+1|, so that (|z-1| + |z+1|)/2 <= 1 + h (a-1) = A;
///           A + sqrt(A^2 - 1)
inline double ellipse_around(double half, double axis) {
  const double beyond = half * (axis - 1) * (1 + 1e-15);
  return (1 + beyond + std::sqrt(beyond * (2 + beyond))) * (1 + 1e-15);
}

/// A bound of all functions on an element where |P_i(x)| <= along^i and |P_j(y)| <= across^j, rounded up.
[[nodiscard]] double size_around(const SectorFunctions& functions, std::size_t element, double along,
                                 double across);

/// Of the functions first, ..., last - 1 on an element.
[[nodiscard]] PolynomialSizes polynomial_sizes(const SectorFunctions& functions, std::size_t element,
                                               std::size_t first, std::size_t last);

}  // namespace radcert
