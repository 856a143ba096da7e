// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/core/outcome.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The norm of K as far as the nodes show it.
/// Maths     max_i rho(v_i)/pi Int |G(v_i,Q)| dS_Q
/// Source    [ac98, (3)]
/// Requires  a number for each node
/// Result    an estimate of ||K|| from below
/// Limits    not guaranteed
Approximation largest_row(std::span<const double> rho_at_nodes, std::span<const double> kernel_integral);

/// The norm of K on C(S) or L^infinity(S).
/// Maths     on a closed unoccluded surface Int G = pi makes it sup rho; on an open one largest_row estimates
///           it from below
/// Source    [ac98, (3)-(5)]
/// Requires  an expression for every piece; kernel_integral may be empty where the surface is closed, and
///           rho_at_nodes where the reflectivity is also a constant on every piece, else ContractViolation
/// Result    guaranteed where the surface is closed and the reflectivity is a constant on every piece: the
///           nearest double, its distance from the constant rounded up as radius
/// Limits    an estimate elsewhere
Approximation norm_of_K(const Surface& surface, const PiecewiseExpression& reflectivity,
                        std::span<const double> rho_at_nodes, std::span<const double> kernel_integral);

/// Throws InputError at /reflectivity unless the norm is below 1.
void refuse_norm_from_one(const Approximation& norm);

/// Whether the reflectivity is below 1 on the whole surface, and with it the norm of K.
/// Maths     sup rho < 1 over S; ||K|| = sup_P rho(P)/pi Int_S G(P,Q) V(P,Q) dS_Q <= sup rho: in each
///           direction one point is seen at most, and the cosine's integral over a half sphere is pi
/// Source    [ac98, (3)-(5)]
/// Requires  a surface with charts in balls, an expression for every piece
/// Result    proved, constants exactly, others by balls over boxes of parameters that are bisected; or the
///           piece where it is not proved
/// Limits    where rho comes close to 1 the boxes may not be small enough
Outcome<void> reflectivity_below_one(const Surface& surface, const PiecewiseExpression& reflectivity);

}  // namespace radcert
