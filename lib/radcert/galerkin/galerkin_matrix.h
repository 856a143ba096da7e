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

/// What the matrix I - A as stored keeps of the definiteness of the exact one.
/// Maths     v^T (I - A) v >= bound v^T v, bound = absorptivity - (1 - absorptivity) defect - radius. Proof:
///           let rho = 1 - absorptivity, W the masses of the functions with the weight 1/rho, and A* the
///           exact integrals. By Schur's test v^T A* v <= rho v^T W v, W differs from I by `defect` at most
///           in the 2-norm, and A from A* by `radius`
/// Requires  0 < absorptivity <= 1, 1 less the largest reflectivity; radius and defect >= 0
/// Result    rounded down; not positive where nothing is known, not even that the system has one solution
/// Limits    an estimate, as the radii and the defect are
[[nodiscard]] double definiteness_as_stored(double absorptivity, double radius, double defect);

}  // namespace radcert
