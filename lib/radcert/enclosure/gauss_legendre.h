// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// legendre_rule, made once for each n and BallPrecision::current(); safe to ask for from several threads.
/// Limits    kept until the program ends
[[nodiscard]] std::shared_ptr<const IntervalRule<Ball>> enclosed_gauss_rule(int n);

/// The error of the n-point Gauss-Legendre rule for an analytic function.
/// Maths     f analytic and |f| <= M in the closed ellipse E_rho with foci -1, 1 and half axes (rho +
///           1/rho)/2, (rho - 1/rho)/2:  |Int_-1^1 f - Q_n f| <= (4 + 4/(4n^2 - 1)) M rho^(-2n) / (1 -
///           rho^-2)
/// Source    N. Trefethen, "Approximation Theory and Approximation Practice", theorem 19.3, with 64/15 for n
///           >= 2; P. Rabinowitz, "Rough and ready error estimates in Gaussian integration of analytic
///           functions", 1969. Proof: f = sum a_k T_k with |a_k| <= 2 M rho^-k (theorem 8.1 there). Q_n is
///           exact up to degree 2n - 1, odd k give 0 = 0, and for even k >= 2n, |Int T_k| = 2 / (k^2 - 1) <=
///           2 / (4n^2 - 1), |Q_n T_k| <= 2 because the weights are positive with sum 2
/// Requires  n >= 1, rho > 1, else ContractViolation
/// Result    the factor of M, an upper bound
[[nodiscard]] Ball gauss_error_factor(int n, double rho);

}  // namespace radcert
