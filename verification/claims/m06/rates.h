// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/framework/check.h"

namespace radcert::verification::m06 {

/// A problem of papers/m06/problems.
[[nodiscard]] Problem problem_named(const std::string& name);

/// The levels of a problem that a budget solves: all but the last for quick, so many more are left out as
/// said.
[[nodiscard]] std::vector<int> levels_for(const Problem& problem, Budget budget, int fewer = 0);

/// Errors over levels.
struct Errors {
  std::vector<double> mesh_sizes;
  std::vector<Approximation> errors;
};

/// Which nodes an error is taken over.
using NodeChoice = std::function<bool(const NodeValue& node)>;

/// What a study measured, level by level.
/// Maths     node: max |u - u_n| over the nodes chosen; uniform: max |u - u_n| over the sample of a level;
///           discretisation: max |K(I-P_n)u|
/// Source    [m06, (23), (24), (26)]
/// Requires  levels of the problem, or any others
/// Result    radii are those of the level, which are estimates; a uniform error has none
[[nodiscard]] Errors node_errors(const Problem& problem, const std::vector<int>& levels, const Bench& bench,
                                 const NodeChoice& choice = {});
[[nodiscard]] Errors uniform_errors(const Problem& problem, const std::vector<int>& levels,
                                    const Bench& bench);
[[nodiscard]] Errors discretisation_errors(const Problem& problem, const std::vector<int>& levels,
                                           const Bench& bench);

/// The order from one level to the next.
/// Maths     log(e_(k-1)/e_k)/log(h_(k-1)/h_k)
/// Requires  1 <= k < number of levels
/// Result    the radius is that of both errors, carried over; infinite where an error is not above its radius
/// Limits    rounded
[[nodiscard]] Approximation order_at(const Errors& errors, std::size_t k);
[[nodiscard]] Approximation last_order(const Errors& errors);

/// The last error's radius as a part of it: the noise that the order is free of.
[[nodiscard]] Approximation noise(const Errors& errors);

}  // namespace radcert::verification::m06
