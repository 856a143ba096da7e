// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "radcert/core/contract.h"

namespace radcert {

/// How well polynomials approximate a function on a triangle that is analytic about it.
/// Maths     f analytic where sum |lambda_i| < g, lambda the complex barycentric coordinates with the sum 1,
///           and |f| <= bound there. Then a polynomial q of degree p has |f - q| <= result on the triangle:
///           result = bound / (1 - 1/rho) sum_(m > p) sqrt(2 (4m + 1)) rho^-m, rho = g + sqrt(g^2 - 1) Proof.
///           F(X) = f(X_1^2, X_2^2, X_3^2) is even on the unit sphere. On a great circle X(z) = cos(z) A +
///           sin(z) B, A and B orthonormal, sum X_i(z)^2 = 1 and sum |X_i(z)|^2 = |cos z|^2 + |sin z|^2 =
///           cosh(2 Im z), so that F is analytic and bounded there for cosh(2 |Im z|) < g, which is e^(2 |Im
///           z|) < rho. Let Y_l be the part of F in the spherical harmonics of degree l, zero for odd l. At a
///           point X, Y_l(X) = (2l + 1)/2 Int_-1^1 M(t) P_l(t) dt, where M(cos z) is the mean of F over the
///           circle at the angle z about X: even, 2 pi-periodic, analytic and bounded in the same strip as a
///           mean of such functions over great circles through X. So M = sum c_k T_k, k even, |c_k| <= 2
///           bound rho^(-k/2). As T_k is orthogonal to P_l for k < l, as Int T_k^2 <= 1 and Int P_l^2 = 2/(2l
///           + 1), |Y_l(X)| <= (2l + 1)/2 sqrt(2/(2l + 1)) sum_(k = l, l+2, ...) 2 bound rho^(-k/2); with l =
///           2m this is sqrt(2 (4m + 1)) bound rho^-m / (1 - 1/rho). The series of the Y_l converges
///           absolutely, so to F; and the sum of Y_l, l <= 2p, is even in each X_i, as F is: a polynomial of
///           degree p in the squares
/// Source    ours; the ellipses sum |lambda_i| = g are the level lines of Siciak's function of a triangle
///           (Baran, 1988)
/// Requires  0 <= bound, 0 <= degree, else ContractViolation
/// Result    rounded up; infinite unless g > 1
[[nodiscard]] inline double approximation_bound(double bound, double g, int degree) {
  expects(bound >= 0 && degree >= 0, "a bound and a degree that are not negative", named("bound", bound),
          named("degree", degree));
  if (!(g > 1) || !std::isfinite(bound)) return std::numeric_limits<double>::infinity();
  // Far more than the roundings of what follows, and a rate that is certainly not too large.
  constexpr double up = 1 + 0x1p-30;
  const double rho = (g + std::sqrt((g - 1) * (g + 1))) * (1 - 0x1p-40);
  if (!(rho > 1)) return std::numeric_limits<double>::infinity();
  const double q = 1 / rho;
  const double first = degree + 1;
  // sqrt(4 (m + i) + 1) <= sqrt(4m + 1) (1 + i / (2m)), and sum i q^i = q / (1 - q)^2.
  const double series = 1 / (1 - q) + q / (2 * first * (1 - q) * (1 - q));
  return bound * std::sqrt(2 * (4 * first + 1)) * std::pow(rho, -first) * series / (1 - q) * up;
}

}  // namespace radcert
