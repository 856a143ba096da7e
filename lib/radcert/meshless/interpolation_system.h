// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/meshless/radial_basis.h"

namespace radcert {

/// The system that makes a basis interpolate at its sites.
/// Maths     A c = f,  a_ij = phi_j(p_i): then sum_j c_j phi_j(p_i) = f_i
/// Source    [psg10, section IV-A]: for an interpolation basis A = I
/// Result    factored once, solved for any f; the same bits for every number of threads
/// Limits    A is kept sparse; elements without a support fill it: n^2 numbers
class InterpolationSystem {
public:
  /// Refused: a basis without a value at one of its sites; a matrix that elimination finds singular.
  [[nodiscard]] static Outcome<InterpolationSystem> make(const RadialBasis& basis);
  ~InterpolationSystem();
  InterpolationSystem(InterpolationSystem&&) noexcept;
  InterpolationSystem& operator=(InterpolationSystem&&) noexcept;

  /// The coefficients of the interpolant of f. ContractViolation unless there are n values.
  [[nodiscard]] std::vector<double> solve(std::span<const double> f) const;
  /// A^-1 M in place of M, on all threads; the bits do not depend on their number. ContractViolation unless M
  /// has n rows.
  void solve_columns(Matrix<double>& matrix) const;
  /// What coefficients leave of values: f_i - sum_j a_ij c_j, summed in long double, so that its own error is
  /// below a thousandth of the rounding of such a sum in double.
  [[nodiscard]] std::vector<double> residual(std::span<const double> c, std::span<const double> f) const;
  /// sum_j |a_ij| |c_j| at each site, rounded: by what parts of it roundings change values.
  [[nodiscard]] std::vector<double> term_sizes(std::span<const double> c) const;
  /// An estimate, from below, of the condition in the 1-norm, |A| |A^-1|: Hager (1984), Higham (1988).
  [[nodiscard]] double condition() const;

private:
  struct Parts;
  explicit InterpolationSystem(std::unique_ptr<const Parts> parts);
  std::unique_ptr<const Parts> parts_;
};

}  // namespace radcert
