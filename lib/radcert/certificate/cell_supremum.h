// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace radcert::certificate {

/// The most nodes of a rule in one parameter of a cell.
inline constexpr int most_cell_nodes = 16;

/// A bound of |p| on [-1,1]^2 for the polynomial p of degree n_s - 1 and n_t - 1 from its values at the
/// tensor Gauss nodes.
/// Maths     p = sum p(x_i) l_i, l_i(x) = w_i sum_(k<n) (k+1/2) P_k(x_i) P_k(x), since Gauss' rule is exact
///           for P_k l_i. In one variable f(theta) = p(cos theta) is a trigonometric polynomial of degree m =
///           n - 1; where |f| is largest, M, |f| >= M cos(m phi) at the distance phi <= pi/m (Riesz). The
///           zeros of T_N are at most pi/(2N) from it: M <= max_a |p(xi_a)| / cos(m pi/(2N)), N = 8n here,
///           and so in two variables, one after the other
/// Source    H. Ehlich, K. Zeller, "Schwankung von Polynomen zwischen Gitterpunkten", Math. Z. 86 (1964)
/// Requires  values by i, j, each within the radius of the exact one; 1 <= n_s, n_t <= most_cell_nodes, else
///           ContractViolation
/// Result    rounded up, at most 4 % above max |p| but for radius and rounding
[[nodiscard]] double cell_supremum(std::span<const double> values, double radius, int nodes_s, int nodes_t);

/// A bound of the norm of interpolation at n Gauss nodes, from sup to sup.
/// Maths     sum |l_i(x)| is at each x one of the polynomials sum +-l_i, of degree n - 1: at most the largest
///           one at the same zeros / cos((n-1) pi/(2N))
/// Requires  1 <= n <= most_cell_nodes, else ContractViolation
[[nodiscard]] double interpolation_norm(int n);

}  // namespace radcert::certificate
