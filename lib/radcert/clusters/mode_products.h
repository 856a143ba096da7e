// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/core/matrix.h"

namespace radcert {

/// A small matrix times several vectors.
/// Maths     y_c += A x_c for every c, A the first `rows` rows and `columns` columns of a matrix
/// Requires  as many y as x; `rows` a multiple of Pack::lanes; no y overlaps another vector
/// Result    each entry of y by fused additions in ascending order of the columns: its bits do not depend on
///           the other vectors
void add_mode_product(const Matrix<double>& a, std::size_t rows, std::size_t columns,
                      std::span<const double* const> x, std::span<double* const> y);

}  // namespace radcert
