// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/core/matrix.h"

namespace radcert {

/// The rows of a matrix that a thread multiplies at a time: their sums fit into the first-level cache, and
/// what it reads of a column is half a page.
inline constexpr std::size_t rows_at_a_time = 256;

/// A matrix times a vector.
/// Maths     y_i = sum_j a_ij x_j, the columns in ascending order
/// Requires  as many columns as entries of x, as many rows as entries of y; y is none of the others
/// Result    |error_i| <= n u / (1 - n u) sum_j |a_ij x_j|, n columns; the same bits for any number of
///           threads; Interrupted when asked to stop
/// Limits    no overflow
void multiply(const Matrix<double>& a, std::span<const double> x, std::span<double> y);

/// The sizes of a matrix's entries times a vector.
/// Maths     y_i = sum_j |a_ij| x_j, the columns in ascending order
/// Requires  as multiply
/// Result    as multiply; where x >= 0 each y_i is below (1 - u)^-n times the exact sum and above (1 - u)^n
///           times it, as far as nothing underflows
/// Limits    as multiply
void multiply_sizes(const Matrix<double>& a, std::span<const double> x, std::span<double> y);

}  // namespace radcert
