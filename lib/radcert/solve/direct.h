// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"

namespace radcert {

/// The collocation system by Gaussian elimination with partial pivoting.
/// Maths     (I - K) u = e
/// Source    [ac98, (40)-(41)]
/// Requires  K square, I - K regular: ||K|| < 1 as an operator does not make ||K_n|| < 1, but for fine enough
///           triangulations I - K_n is regular with it [ac98, Theorem 3.1]
/// Result    one thread, so the same bits for any number of threads
/// Limits    2/3 n^3 operations, a second matrix of storage
class DirectSolver {
public:
  explicit DirectSolver(const Matrix<double>& k);
  ~DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) = delete;

  std::vector<double> solve(std::span<const double> e) const;

  /// The maximum norm of (I - K)^-1, from all of the inverse.
  /// Maths     max_i sum_j |((I - K)^-1)_ij|
  /// Result    rounded: relatively wrong by about the condition number times n u
  /// Limits    2 n^3 operations, of a matrix kept by 64 columns at a time
  double inverse_norm() const;

private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace radcert
