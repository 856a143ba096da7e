// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"

namespace radcert {

/// A matrix-vector product as if summed in twice the working precision.
/// Maths     y_i = sum_j a_ij x_j, each product and sum split into a rounded value and its exact error
/// Source    Ogita, Rump, Oishi: Accurate sum and dot product (2005), algorithm Dot2
/// Requires  as many columns as entries of x
/// Result    |error_i| <= u |y_i| + (n u)^2 sum_j |a_ij x_j|; the same bits everywhere
/// Limits    no overflow
inline std::vector<double> accurate_product(const Matrix<double>& a, std::span<const double> x) {
  std::vector<double> sum(a.rows());
  std::vector<double> error(a.rows());
  for (std::size_t j = 0; j < a.columns(); ++j) {
    const std::span<const double> column = a.column(j);
    for (std::size_t i = 0; i < column.size(); ++i) {
      const double product = column[i] * x[j];
      const double product_error = std::fma(column[i], x[j], -product);
      const double before = sum[i];
      sum[i] = before + product;
      const double back = sum[i] - before;
      error[i] += product_error + ((before - (sum[i] - back)) + (product - back));
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += error[i];
  return sum;
}

}  // namespace radcert
