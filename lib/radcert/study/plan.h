// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "radcert/core/memory_plan.h"
#include "radcert/study/problem.h"

namespace radcert {

/// The memory of one level, before any of it is taken.
/// Maths     n unknowns: the matrix, with `direct` its factors, and with `verified` four more, 8 n^2 bytes
///           each; with `gmres` the Krylov vectors; vectors; per-chunk row sums; with interpolated geometry a
///           chart an element and a second set of nodes
/// Source    the loops of collocation, solve and study
/// Result    bytes by item; counts that exceed 64 bits count as 2^64 - 1
/// Limits    what the standard library and the operating system add is not counted
MemoryPlan level_plan(std::uint64_t elements, std::uint64_t functions_per_element, SolverName solver,
                      const std::optional<InterpolatedGeometry>& geometry = std::nullopt);

}  // namespace radcert
