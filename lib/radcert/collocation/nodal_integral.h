// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A row of the collocation matrix, without rho/pi, applied to nodal values, and what moves it.
/// Maths     g_j = Int G(P,Q) V(P,Q) l_j(Q) dS_Q for all functions of all elements, known within d_j:
///           value = sum g_j u_j, left_out = sum |u_j| d_j, size = sum |g_j u_j|, weight = sum (|g_j| + d_j)
struct NodalIntegral {
  double value = 0;
  double left_out = 0;  ///< what the rules may have changed, an estimate
  double size = 0;      ///< to which the rounding of the sum is relative
  double weight = 0;    ///< nodal values within r move the value by no more than r times this
};

/// Int_S G V u_n dS at points of S that need be no nodes, u_n given by its values at the nodes.
/// Maths     P_i -> Int_S G(P_i,Q) V(P_i,Q) u_n(Q) dS_Q
/// Source    [ac98, (40)]: the entries of the collocation matrix for any points, and their sum
/// Requires  as ElementSweep; a value a basis function and element, in the order of collocation_nodes
/// Result    a number a point; the same bits for any number of threads
/// Limits    radii are estimates. No matrix is kept
[[nodiscard]] std::vector<NodalIntegral> nodal_integrals(const Surface& surface,
                                                         const Triangulation& triangulation,
                                                         const TriangleBasis<double>& basis,
                                                         std::span<const double> values,
                                                         std::span<const CollocationPoint<double>> points,
                                                         const Tolerance& tolerance);

}  // namespace radcert
