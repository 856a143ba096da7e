// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The matrix of K P_n at the nodes, with what is known of its errors.
/// Maths     entries(i, k p + j) = rho(v_i)/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q, p functions an element;
///           kernel_integral[i] = Int_S |G(v_i,Q)| dS_Q;  row_radius[i] = sum over the row of the entries'
///           radii
/// Source    [ac98, (40)]
/// Result    each entry to the tolerance, relative to the row's Int |G|; radii are estimates
/// Limits    dense
template <Real R>
struct CollocationMatrix {
  Matrix<R> entries;
  std::vector<R> kernel_integral;
  std::vector<R> row_radius;
};

/// Assembles the matrix, elements in parallel.
/// Maths     see CollocationMatrix
/// Source    [ac98, (40)]
/// Requires  one node a basis function and element, one reflectivity a node
/// Result    the same bits for any number of threads; Interrupted when asked to stop
/// Limits    in double surfaces that are unoccluded, where V = 1, and meshes; beyond double unoccluded
///           surfaces, else ContractViolation
template <Real R>
CollocationMatrix<R> assemble(const Surface& surface, const Triangulation& triangulation,
                              const TriangleBasis<R>& basis, std::span<const CollocationPoint<R>> nodes,
                              std::span<const R> reflectivity, const Tolerance& tolerance = Tolerance());

extern template CollocationMatrix<double> assemble<double>(const Surface&, const Triangulation&,
                                                           const TriangleBasis<double>&,
                                                           std::span<const CollocationPoint<double>>,
                                                           std::span<const double>, const Tolerance&);

extern template CollocationMatrix<Mpfr<50>> assemble<Mpfr<50>>(const Surface&, const Triangulation&,
                                                               const TriangleBasis<Mpfr<50>>&,
                                                               std::span<const CollocationPoint<Mpfr<50>>>,
                                                               std::span<const Mpfr<50>>, const Tolerance&);

}  // namespace radcert
