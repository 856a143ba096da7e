// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

namespace radcert {

/// The Bernstein ellipse with foci -1, 1 through z: the sum of its half axes.
/// Maths     rho = |z + sqrt(z^2 - 1)| >= 1; n-point Gauss quadrature of a function analytic inside converges
///           like rho^(-2n)
/// Source    Trefethen, Approximation Theory and Approximation Practice, Theorem 19.3
/// Result    double: it chooses a rule and enters no result
inline double bernstein_radius(const std::complex<double>& z) {
  const std::complex<double> root = std::sqrt(z * z - 1.0);
  return std::max(std::abs(z + root), std::abs(z - root));
}

/// The number of Gauss points a variable needs for a truncation error, with polynomial factors of a degree.
/// Maths     rho^(-2 n) <= truncation
/// Source    see bernstein_radius
/// Requires  0 < truncation < 1
/// Result    a first guess: the comparison of two rules decides
/// Limits    the constant of the bound is left out
inline int points_for(double rho, int degree, double truncation) {
  const double analytic = std::ceil(-std::log(truncation) / (2 * std::log(std::max(rho, 1.05))));
  return static_cast<int>(std::min(analytic, 1000.0)) + (degree + 1) / 2;
}

}  // namespace radcert
