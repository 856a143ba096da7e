// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// Interpolation on elements at tensor Gauss nodes.
/// Maths     the interpolant of f is sum c_ij P_i(x) P_j(y), c_ij = sum_ml M_im M_jl f(x_m, x_l), M_im =
///           (2i+1)/2 w_m P_i(x_m)
/// Requires  1 <= nodes <= most_gauss_nodes, else ContractViolation
class ElementInterpolation {
public:
  explicit ElementInterpolation(int nodes);

  /// The nodes of a box of a sector, by m, l.
  [[nodiscard]] std::vector<Vector<double>> points(const Sector& sector, const SectorBox& box) const;
  /// The coefficients, by i, j, from values at the nodes, `stride` apart.
  void coefficients(std::span<const double> values, std::size_t stride, std::span<double> out) const;
  /// What rounding makes of the interpolant in the maximum norm, for values up to `size` that are off by `off`.
  /// Maths     n = nodes: M is off by 26 n^2 u (2i+1)/2 w_m, and sum_m (2i+1)/2 w_m = 2i+1: the coefficients
  ///           are off by (2i+1)(2j+1) (64 n^2 u size + off), which sum to n^4 (64 n^2 u size + off)
  [[nodiscard]] double rounding(double size, double off) const;

private:
  std::size_t nodes_;
  std::vector<double> to_coefficients_;  ///< M, by i, m
};

}  // namespace radcert
