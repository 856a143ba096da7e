// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "radcert/core/files/kept_numbers.h"
#include "radcert/core/memory_plan.h"
#include "radcert/study/operator_route.h"
#include "radcert/study/triangle_basis_choice.h"

namespace radcert {

struct Problem;
struct LevelOutcome;
struct LevelSharing;

/// Collocation with functions that are polynomials on each triangle.
/// Maths     u_n = sum_j u_n(v_j) l_j, (I - P_n K) u_n = P_n E
/// Source    [ac98, (39)-(41)], [m06]
struct Collocation {
  TriangleBasisChoice basis;
};

/// Refuses what collocation does not allow in a problem; see check(problem).
/// Maths     0 <= degree <= 10, 8 with a solver that proves; 0 <= alpha < 1/3, and alpha > 0 where pieces or
///           interpolated elements meet at an angle; interpolants of degree 1 to 6; a plan within
///           `memory_limit` bytes at every level
void check(const Problem& problem, const Collocation& method, const Surface& surface,
           std::uint64_t memory_limit);

/// The memory of one level, before any of it is taken.
/// Maths     n unknowns: the matrix, 8 n^2 bytes, or what plan_clusters says, and what the solver adds to it;
///           vectors; per-chunk row sums; with interpolated geometry a chart an element and a second set of
///           nodes
/// Source    the loops of collocation, solve and study
/// Requires  a problem that collocates, with a solver of linear_solvers()
/// Result    bytes by item; counts that exceed 64 bits count as 2^64 - 1
/// Limits    what the standard library and the operating system add is not counted
[[nodiscard]] MemoryPlan level_plan(const Problem& problem, std::uint64_t elements);

/// Solves a problem that collocates at one level; see solve_level.
/// Source    [ac98, (40)-(41)]
/// Requires  a checked problem with this method
/// Result    with a solver that proves, what verified_level says
/// Limits    radii are estimates because those of the matrix and of Ku are. From them to u_n leads a
///           contraction of all matrices within the radii; with `direct`, where there is none, the norm of
///           the inverse, N d / (1 - N r) for defects d and row radii r
[[nodiscard]] LevelOutcome solve(const Problem& problem, const Collocation& method, int level,
                                 const OperatorRoute& route, const LevelSharing& sharing, KeptNumbers* kept);

}  // namespace radcert
