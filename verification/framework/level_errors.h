// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "radcert/formats/result/stored_levels.h"
#include "radcert/study/study.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/check.h"
#include "verification/framework/observed_order.h"

namespace radcert::verification {

/// first, first + 1, ..., last.
[[nodiscard]] std::vector<int> levels_from(int first, int last);

/// Errors of one's own over levels.
/// Maths     h = 2^(1/2) 2^-level, the longest side of half a unit square refined so often
[[nodiscard]] LevelErrors over_levels(const std::vector<int>& levels,
                                      const std::function<Approximation(int level)>& error);

/// Whether an element has a vertex on the border of its chart.
[[nodiscard]] bool touches_the_border(const Surface& surface, const ParameterTriangle& element);

/// Which nodes an error is taken over.
using NodeChoice = std::function<bool(const NodeValue& node, const ParameterTriangle& element)>;

/// What solved levels of a problem have for errors.
/// Maths     node: max |u - u_n| over the nodes chosen; uniform: max |u - u_n| over the sample of a level;
///           discretisation: max |K(I-P_n)u| over the nodes
/// Requires  a problem with `solution`
/// Result    radii are those of the level, which are estimates; a uniform error has none, and counts as
///           without one
/// Limits    the maximum over no node is 0, which has no order
[[nodiscard]] LevelErrors node_errors(const Bench& bench, const Problem& problem,
                                      const std::vector<int>& levels, const NodeChoice& choice = {});
[[nodiscard]] LevelErrors uniform_errors(const Bench& bench, const Problem& problem,
                                         const std::vector<int>& levels);
[[nodiscard]] LevelErrors discretisation_errors(const Bench& bench, const Problem& problem,
                                                const std::vector<int>& levels);

}  // namespace radcert::verification
