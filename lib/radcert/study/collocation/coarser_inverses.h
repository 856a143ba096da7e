// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/problem.h"

namespace radcert {

/// How large the inverses of the collocation matrices of coarser levels are.
/// Maths     max norm of (I - K_n)^-1, rounded, for the levels below `level` that have at most
///           most_unknowns_of_inverses unknowns, the two finest of them
/// Requires  a checked problem that collocates, its basis
/// Result    ascending in the level; fewer than two where there are not so many
[[nodiscard]] std::vector<double> inverse_norms_of_coarser_levels(const Problem& problem, int level,
                                                                  const TriangleBasis<double>& basis);

}  // namespace radcert
