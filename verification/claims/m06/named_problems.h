// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

/// A problem of papers/m06/problems.
[[nodiscard]] Problem problem_named(const std::string& name);

/// The levels of a problem that a budget solves: all but the last for quick, so many more are left out as
/// said.
[[nodiscard]] std::vector<int> levels_for(const Problem& problem, Budget budget, int fewer = 0);

/// The levels that an order is taken from: from 1 on, at level 0 an element is as large as a piece; up to 3
/// at quick, else up to the problem's last.
[[nodiscard]] std::vector<int> levels_of_an_order(const Problem& problem, Budget budget);

/// The nodes (13) that the paper chooses for a degree: alpha_0 for r = 1 and 3, the centroid for r = 0; where
/// any alpha will do, or none is known, 1/10.
/// Requires  0 <= r <= 5
[[nodiscard]] TriangleBasis<double> chosen_nodes(int r);
/// The nodes (13) at alpha = 1/10.
[[nodiscard]] TriangleBasis<double> nodes_at_a_tenth(int r);

}  // namespace radcert::verification::m06
