// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/iteration.h"

namespace radcert {

/// Of a matrix whose powers are looked at, unless a caller says otherwise.
extern const WorkLimit most_matrix_squarings;

/// No power of a matrix was found to contract.
struct NoPowerContracts {
  std::size_t power = 1;  ///< the last that was tried
  double theta =
      0;  ///< the least bound of the spectral radius of its sizes; infinite for numbers that are not finite
  bool diverges = false;  ///< the matrix has no negative entry, and a spectral radius that is not below 1
};

/// The Neumann series of a matrix of which a power contracts.
/// Maths     K = R^k, k = 1, 2, 4, ..., the first for which |K| w <= theta w with theta < 1: then R^m -> 0,
///           and (I - R) x = e is (I - K) x = e + R e + ... + R^(k-1) e. A matrix with entries of both signs
///           may well converge where |R| does not contract
/// Source    Gelfand's formula: |R^k|^(1/k) tends to the spectral radius; contraction.h
/// Result    immutable. A matrix without negative entries is tried with k = 1 alone: its contraction is found
///           where there is one
/// Limits    holds R, and K where k > 1; each squaring takes n^3 multiplications
class NeumannSeries {
public:
  /// At most 2^most_squarings = k; ContractViolation unless R is square and not empty. The same bits for any
  /// number of threads; InputError where memory does not do; Interrupted when asked to stop.
  [[nodiscard]] static Outcome<NeumannSeries, NoPowerContracts> make(
      Matrix<double> r, long most_squarings = most_matrix_squarings.value());

  [[nodiscard]] const Matrix<double>& matrix() const { return r_; }
  /// k.
  [[nodiscard]] std::size_t power() const { return power_; }
  /// A bound of the spectral radius of R, proved: theta^(1/k), rounded up.
  [[nodiscard]] double spectral_radius_bound() const;

  /// The solution of (I - R) x = e: v <- e + K v until the bound theta/(1 - theta) |v' - v|_w, with rounding,
  /// is at most tolerance max |v|, in double; where that does not reach it, and without a tolerance, by
  /// solve_by_neumann. error_bound holds for R and e as stored: it includes the rounding errors of K and of
  /// its right-hand side, which may exceed the tolerance; `iterations` counts reflections, k a step.
  /// ContractViolation unless e has R's size and the tolerance is one that `iterate` takes.
  [[nodiscard]] Outcome<IterativeSolution, NotReached> solve(std::span<const double> e,
                                                             std::optional<double> tolerance) const;

private:
  /// Nothing where rounding errors stop the descent.
  [[nodiscard]] std::optional<IterativeSolution> plain_series(const Matrix<double>& k,
                                                              std::span<const double> e,
                                                              double tolerance) const;

  Matrix<double> r_;
  std::optional<Matrix<double>> k_;  ///< where k > 1
  double size_ = 0;                  ///< max_i sum_j |r_ij|, rounded up
  double radius_ = 0;                ///< the same norm of the rounding error of K, rounded up
  std::size_t power_ = 1;
  Contraction contraction_;
};

}  // namespace radcert
