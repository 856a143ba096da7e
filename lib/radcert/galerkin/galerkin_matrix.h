// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/galerkin/pair_integrals.h"

namespace radcert {

/// The matrix of the kernel in Galerkin's method, with what is known of its errors.
/// Maths     entries(k p + a, l p + b) = 1/pi Int_{Delta_k} Int_{Delta_l} psi_a(P) G(P,Q) psi_b(Q) dS_Q dS_P,
///           p functions an element; row_radius[i] = sum over the row of the entries' radii, which bounds the
///           2-norm of what the entries are off by, since that is symmetric
/// Source    Galerkin's method: Atkinson, The Numerical Solution of Integral Equations of the Second Kind,
///           1997, 3.3; the symmetry is that of G
/// Result    symmetric to the bit; radii are estimates
/// Limits    dense
struct GalerkinMatrix {
  Matrix<double> entries;
  std::vector<double> row_radius;
};

/// Assembles the matrix: each pair of elements once.
/// Requires  pairs of an element count; serves[k]: whether a row of the element k is wanted. Where it is for
///           neither of two elements their block is zero
/// Result    the same bits for any number of threads; Interrupted when asked to stop
[[nodiscard]] GalerkinMatrix galerkin_matrix(const PairIntegrals& pairs, std::size_t functions,
                                             const std::vector<bool>& serves);

}  // namespace radcert
