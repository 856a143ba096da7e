// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/matrix.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The collocation system in any arithmetic that can compare: the reference for the solvers in double.
/// Maths     (I - K) u = e by Gaussian elimination with partial pivoting
/// Source    [ac98, (40)-(41)]
/// Requires  K square, as many entries in e, I - K regular: a vanishing pivot is a ContractViolation
/// Result    rounded as R rounds
/// Limits    2/3 n^3 operations, one at a time; in double use DirectSolver
template <Real R>
std::vector<R> solve_by_elimination(const Matrix<R>& k, std::vector<R> e) {
  using std::abs;
  const std::size_t n = k.rows();
  expects(k.columns() == n && e.size() == n, "a square matrix and a right-hand side of its size",
          named("rows", n), named("columns", k.columns()), named("values", e.size()));
  Matrix<R> a(n, n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) a(i, j) = (i == j ? R(1) : R(0)) - k(i, j);
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t largest = p;
    for (std::size_t i = p + 1; i < n; ++i)
      if (abs(a(i, p)) > abs(a(largest, p))) largest = i;
    expects(!(a(largest, p) == R(0)), "a regular matrix", named("column", p));
    if (largest != p) {
      for (std::size_t j = p; j < n; ++j) std::swap(a(p, j), a(largest, j));
      std::swap(e[p], e[largest]);
    }
    for (std::size_t i = p + 1; i < n; ++i) a(i, p) = a(i, p) / a(p, p);
    for (std::size_t j = p + 1; j < n; ++j)
      for (std::size_t i = p + 1; i < n; ++i) a(i, j) = a(i, j) - a(i, p) * a(p, j);
    for (std::size_t i = p + 1; i < n; ++i) e[i] = e[i] - a(i, p) * e[p];
  }
  for (std::size_t p = n; p-- > 0;) {
    for (std::size_t j = p + 1; j < n; ++j) e[p] = e[p] - a(p, j) * e[j];
    e[p] = e[p] / a(p, p);
  }
  return e;
}

}  // namespace radcert
