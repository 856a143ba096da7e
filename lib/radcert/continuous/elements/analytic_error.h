// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/continuous/upward.h"

namespace radcert {

/// How far a function is from a polynomial of the degree n-1.
/// Maths     f analytic and |f| <= M in the ellipse with the foci -1, 1 and half axes summing to rho:  some p
///           has |f - p| <= 2 M rho^(1-n)/(rho-1) on [-1,1]
/// Source    N. Trefethen, "Approximation Theory and Approximation Practice", theorem 8.2
/// Requires  n >= 1, rho > 1
/// Result    the factor of M, rounded up
[[nodiscard]] inline double polynomial_error_factor(int n, double rho) {
  return 2 * std::pow(rho, 1 - n) / (rho - 1) * upward;
}

/// The error of the n-point Gauss-Legendre rule for the mean of such a function.
/// Maths     (2 + 2/(4n^2-1)) M rho^(-2n)/(1 - rho^-2)
/// Source    gauss_error_factor, half of it
/// Requires  n >= 1, rho > 1
/// Result    the factor of M, rounded up
[[nodiscard]] inline double gauss_mean_error_factor(int n, double rho) {
  return (2 + 2 / (4.0 * n * n - 1)) * std::pow(rho, -2 * n) / (1 - 1 / (rho * rho)) * upward;
}

/// The same for n = 1, 2, ..., one after the other and without a power, for up to a hundred.
class GaussMeanErrors {
public:
  explicit GaussMeanErrors(double rho) : ratio_(1 / (rho * rho)), power_(1 / (1 - ratio_)) {}
  double next() {
    ++nodes_;
    power_ *= ratio_;
    return (2 + 2 / (4.0 * nodes_ * nodes_ - 1)) * power_ * upward;
  }

private:
  double ratio_;
  double power_;  ///< rho^(-2n)/(1 - rho^-2)
  int nodes_ = 0;
};

}  // namespace radcert
