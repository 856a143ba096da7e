// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "radcert/core/outcome.h"
#include "radcert/solve/contraction.h"

namespace radcert {

/// The solver that goes on without a contraction.
inline constexpr std::string_view gmres_by_estimate = "gmres_by_estimate";

/// The most unknowns of a level whose inverse is formed for such an estimate.
inline constexpr std::size_t most_unknowns_of_inverses = 3072;

/// A bound of the norm of (I - K_n)^-1 on a level from the norms on coarser ones.
/// Maths     N = max(1, 2 max of the norms). Where the method converges the inverses stay bounded [ac98,
///           Theorem 3.1 and (47)], and their norms settle; the factor 2 is for what they may still grow by
/// Source    ours
/// Requires  norms of the maximum norm, ascending in the level
/// Result    an estimate, no bound. Refused in words for fewer than two, one that is not finite, or where the
///           last two differ by more than a fifth of the larger: they have not settled
[[nodiscard]] Outcome<double> estimated_inverse_norm(std::span<const double> of_coarser_levels);

/// What an iteration needs in the place of a contraction, from an estimate of the norm of the inverse.
/// Maths     weights 1 and 1/(1 - theta) = N/(1 - N r): if N bounds the inverse of I - K, this bounds that of
///           I - K' for all K' whose rows differ from those of K by r in all
/// Requires  inverse_norm >= 1, finite; row_radius >= 0; inverse_norm row_radius < 1, else
///           ContractViolation
/// Result    inverse_bound() is as good as the estimate; theta() is 1 - 1/N', and bounds no norm of K: what
///           iterate() adds for rounding to second order with it is an estimate too
[[nodiscard]] Contraction contraction_by_estimate(const VectorParts& parts, double inverse_norm,
                                                  double row_radius);

}  // namespace radcert
