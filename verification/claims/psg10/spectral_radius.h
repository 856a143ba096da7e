// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/scalar/approximation.h"
#include "radcert/solve/contraction.h"

namespace radcert::verification::psg10 {

/// A proved bound of the spectral radius of a matrix, on that side of 1 on which it lies.
/// Maths     from above where |R| w <= theta w with theta < 1; else from below, min_i (R w)_i / w_i of the
///           principal submatrix of the rows whose sum is at least a thousandth of the largest, which has no
///           larger spectral radius: rows of points that see nothing have the quotient 0
/// Source    Collatz (1942), Wielandt (1950); Perron and Frobenius
/// Requires  a square matrix, not empty, without negative entries
/// Result    guaranteed for the numbers as stored; without a radius where neither bound says on which side
[[nodiscard]] inline Approximation proved_spectral_radius(const Matrix<double>& r) {
  const auto above = find_contraction(r);
  if (above) return Approximation::proved(above->theta(), 0);
  std::vector<double> sums(r.rows());
  for (std::size_t j = 0; j < r.columns(); ++j)
    for (std::size_t i = 0; i < r.rows(); ++i) sums[i] += r(i, j);
  const double least = *std::max_element(sums.begin(), sums.end()) / 1000;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] >= least) kept.push_back(i);
  Matrix<double> part(kept.size(), kept.size());
  for (std::size_t j = 0; j < kept.size(); ++j)
    for (std::size_t i = 0; i < kept.size(); ++i) part(i, j) = r(kept[i], kept[j]);
  const auto below = find_contraction(part);
  if (!below && below.reason().radius_from_below > 1)
    return Approximation::proved(below.reason().radius_from_below, 0);
  return Approximation::without_radius(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace radcert::verification::psg10
