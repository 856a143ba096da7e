// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/core/matrix.h"

namespace radcert {

/// A matrix-vector product as if summed in twice the working precision.
/// Maths     y_i = sum_j a_ij x_j, each product and sum split into a rounded value and its exact error
/// Source    Ogita, Rump, Oishi: Accurate sum and dot product (2005), algorithm Dot2
/// Requires  as many columns as entries of x
/// Result    |error_i| <= u |y_i| + (n u)^2 sum_j |a_ij x_j|; the same bits everywhere and for any number of
///           threads; Interrupted when asked to stop
/// Limits    no overflow, no underflow
std::vector<double> accurate_product(const Matrix<double>& a, std::span<const double> x);

/// The residual of (I - K) v = e as if summed in twice the working precision.
/// Maths     r_i = e_i - v_i + sum_j k_ij v_j, one sum of n + 2 terms
/// Source    as accurate_product
/// Requires  K square with n rows, n entries in v, e and r; r is none of the others
/// Result    |error_i| <= u |r_i| + ((n + 3) u)^2 (|e_i| + |v_i| + sum_j |k_ij v_j|): digits remain where all
///           of a plain sum's would have cancelled; bits and interruption as accurate_product
/// Limits    as accurate_product
void accurate_residual(const Matrix<double>& k, std::span<const double> v, std::span<const double> e,
                       std::span<double> r);

}  // namespace radcert
