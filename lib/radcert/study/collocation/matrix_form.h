// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "radcert/core/memory_plan.h"
#include "radcert/study/problem.h"

namespace radcert {

/// The names of the forms in which the collocation matrix is held: dense, h2, auto.
[[nodiscard]] std::vector<std::string> operator_names();

/// The number of unknowns up to which `auto` takes the matrix with all its entries.
/// Source    apps/bench/README.md: about where set-up takes as long in either form
inline constexpr std::uint64_t most_dense_unknowns = 8192;

/// Refuses a form that is not known, and `h2` where it does not serve the problem: a method that is no
/// collocation on triangles, an interpolated geometry, a graded triangulation for a solver that proves, a
/// surface with an obstacle_to_clusters, a solver that needs entries, a tolerance outside that of
/// ClusterTolerance.
/// Result    returns, or throws InputError at the place in the problem
void check_operator(const Problem& problem, const Surface& surface);

/// Whether a level of that many unknowns is held as a ClusterOperator.
/// Maths     `h2`: always. `auto`: beyond most_dense_unknowns where `h2` would not be refused, and not with a
///           solver that proves, which is told to by name
///           This is what a level begins with: where no contraction is found for it and the solver is `auto`,
///           the level takes the matrix with its entries, if that and elimination fit into memory, and is
///           refused else
/// Requires  check_operator(problem, surface_of(problem)) returns
[[nodiscard]] bool takes_clusters(const Problem& problem, std::uint64_t unknowns);

/// Adds what a ClusterOperator will need, before it is made.
/// Maths     near entries: 64 leaves near each leaf, on a surface of plane charts, where only leaves at edges
///           are near each other, at most 600 n^(-1/2), but 4 at least, of n leaves, or 96 on graded ones;
///           nodes: 4 kB an unknown, and 12 kB of matrices where it is graded
/// Source    apps/bench/README.md has what was measured: at most 58 leaves; on the cube 222 n^(-1/2); 67
///           where it is graded
/// Limits    an estimate. Once the lists are made they are counted, and more than there is memory for is
///           refused before any entry is integrated
void plan_clusters(MemoryPlan& plan, const Surface& surface, bool is_graded, std::uint64_t unknowns,
                   std::uint64_t functions);
/// With EnclosedClusters beside it, for a solver that proves.
void plan_proved_clusters(MemoryPlan& plan, const Surface& surface, std::uint64_t unknowns,
                          std::uint64_t functions);

}  // namespace radcert
