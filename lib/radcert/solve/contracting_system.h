// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/solve/verified_system.h"

namespace radcert {

/// A solution near a vector, of a matrix that is known by bounds of its products alone.
struct ContractingSolution {
  VerifiedSolution solution;
  double theta = 0;  ///< < 1: |K| w <= theta w
};

/// The solutions of (I - K) u = e from a vector x with a bounded residual.
/// Maths     s >= |K| w entry by entry, w > 0, with theta = max s_i / w_i < 1, for all matrices that are
///           meant: then I - K is regular, for d = u - x = r + K d with |e - x + K x| <= r entry by entry
///           |d|_w <= b = |r|_w / (1 - theta), and |d_i| <= min(b w_i, r_i + b s_i)
/// Source    Collatz (1942); VerifiedSystem with R = I
/// Requires  vectors of one size; weights > 0, sizes >= 0, residual >= 0, else ContractViolation; bounds that
///           hold
/// Result    every such u is enclosed, rounded up. Refused where theta is not below 1 or a number is not
///           finite
[[nodiscard]] Outcome<ContractingSolution> contracting_solution(std::span<const double> x,
                                                                std::span<const double> residual,
                                                                std::span<const double> weights,
                                                                std::span<const double> sizes);

}  // namespace radcert
