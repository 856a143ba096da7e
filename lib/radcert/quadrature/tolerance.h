// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// The relative difference of two rules at which an integral counts as converged.
/// Maths     |finer - coarser| <= converged_difference Int |G l_j|
/// Source    a choice: about 200 roundings, so that the difference is seldom the larger part of the radius
/// Requires  -
/// Result    exceeds what summing a few hundred terms in double may change
/// Limits    double
inline constexpr double converged_difference = 2e-14;

/// What is asked of the error model when an order is chosen.
/// Maths     rho^(-2 order) <= intended_truncation, rho the Bernstein radius
/// Source    see bernstein_radius
/// Requires  -
/// Result    a first guess of the order; the comparison of two rules decides
/// Limits    double
inline constexpr double intended_truncation = 1e-15;

}  // namespace radcert
