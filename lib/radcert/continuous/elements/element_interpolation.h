// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// Interpolation on elements at tensor Gauss nodes.
/// Maths     the interpolant of f is sum c_ij P_i(x) P_j(y), c_ij = sum_ml M_im N_jl f(x_m, y_l), M_im =
///           (2i+1)/2 w_m P_i(x_m), N alike. Of values up to 1 it is n_s n_t at most: the Lebesgue constant
///           of n Gauss nodes is at most n, since (sum |l_i|)^2 <= sum w_i sum l_i^2/w_i, the first sum 2,
///           the second sum_(k<n) (2k+1)/2 P_k^2 <= n^2/2
/// Requires  1 <= nodes <= most_gauss_nodes in either variable, else ContractViolation
class ElementInterpolation {
public:
  ElementInterpolation(int nodes_s, int nodes_t);
  explicit ElementInterpolation(int nodes) : ElementInterpolation(nodes, nodes) {}

  /// The nodes of a box of a sector, by m, l.
  [[nodiscard]] std::vector<Vector<double>> points(const Sector& sector, const SectorBox& box) const;
  /// The coefficients, by i, j, from values at the nodes, `stride` apart.
  void coefficients(std::span<const double> values, std::size_t stride, std::span<double> out) const;
  /// What rounding makes of the interpolant in the maximum norm, for values up to `size` that are off by
  /// `off`.
  /// Maths     n = n_s, m = n_t, k the larger: M is off by 26 n^2 u (2i+1)/2 w_m, and sum_m (2i+1)/2 w_m =
  ///           2i+1: the coefficients are off by (2i+1)(2j+1) (64 k^2 u size + off), which sum to n^2 m^2 (64
  ///           k^2 u size + off)
  [[nodiscard]] double rounding(double size, double off) const;

private:
  std::size_t nodes_s_;
  std::size_t nodes_t_;
  std::vector<double> in_s_;  ///< M, by i, m
  std::vector<double> in_t_;  ///< N, by j, l
};

/// A bound of the Lebesgue constant sup sum_a |l_a| of n Gauss nodes on [-1,1].
/// Maths     at each place it is one of the polynomials sum +-l_a, of degree m = n - 1. Where a trigonometric
///           polynomial f(theta) = p(cos theta) of degree m has its largest size M, |f| >= M cos(m phi) at
///           the distance phi <= pi/m (Riesz); angles pi/(8n) apart are at most pi/(16n) from there: the
///           largest sum at their places / cos(m pi/(16n))
/// Requires  1 <= nodes <= most_gauss_nodes, else ContractViolation
/// Result    proved, at most 2 % too large
[[nodiscard]] double lebesgue_constant(int nodes);

/// A bound of |sum c_ij P_i(x) P_j(y)| on [-1,1]^2.
/// Maths     on each of 4 x 4 parts at most the sum of the sizes of its own coefficients, since |P_k| <= 1:
///           P_i(m + h x) = sum_(k <= i) A_ik P_k(x), A_ik by a Gauss rule that is exact. Of n powers A_ik is
///           off by (2k+1) (20 n^2 + 64) u, and sum_k |A_ik| <= sum_k (2k+1)^(1/2) <= n^2
/// Requires  coefficients by i, j; at most most_gauss_nodes of either, else ContractViolation
/// Result    rounded up; no more than the sum of the coefficients' sizes, but for rounding
[[nodiscard]] double supremum(std::span<const double> coefficients, std::size_t of_x, std::size_t of_y);

}  // namespace radcert
