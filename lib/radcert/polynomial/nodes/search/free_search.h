// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "radcert/polynomial/nodes/free_nodes.h"
#include "radcert/polynomial/nodes/search/symmetric_search.h"

namespace radcert {

/// Which nodes without symmetry to look for: those of a rule with these degrees of precision.
struct FreeGoal {
  int degree = 0;         ///< r, of the functions
  int triangle = 0;       ///< on the triangle
  int parallelogram = 0;  ///< on parallelograms, even; one more comes with it
};
inline constexpr int largest_free_degree = 4;

/// The goal with the order r + 3 at the nodes.
/// Maths     r even: r + 2 on the triangle, and so r + 3 on the parallelogram: no logarithm; r + 1 there
///           and r + 2 here are the same, see products_follow. r odd: r + 1 on the triangle, r + 4 on the
///           parallelogram, of which products have r + 2: a logarithm. Without one products of degree r + 3
///           would have to be exact too, as they are where the rule is so on the triangle: for r = 3 none
///           of 4096 starts came to such nodes inside
/// Source    predicted_orders
/// Requires  degree >= 1
[[nodiscard]] FreeGoal free_goal(int degree);

/// Why a goal is none that can be looked for: more equations than numbers; empty where it is one.
[[nodiscard]] std::optional<std::string> hindrance(const FreeGoal& goal);

/// Nodes as a search leaves them, sharpened, with the largest value of sum |l_j| at points of a lattice.
struct SoughtFreeNodes {
  FreeNodes nodes;
  double norm = 0;
};

/// What a search looked at.
struct FreeSearchResult {
  std::optional<SoughtFreeNodes> best;
  int starts = 0;
  int solutions = 0;  ///< with nodes inside the triangle
};

/// Looks for nodes without symmetry inside the triangle, of the least norm of interpolation.
/// Maths     as search_symmetric_nodes, with a weight and two coordinates for each node; numbers that the
///           equations leave free are held at six digits where the rest is best conditioned
/// Requires  1 <= degree <= largest_free_degree, no hindrance, starts from 1 to most_search_starts, else
///           ContractViolation; `goes_on` as there
/// Result    the same for any number of threads
/// Limits    proves nothing: what is not found may exist. The time of a start grows like the sixth power of
///           the degree
[[nodiscard]] FreeSearchResult search_free_nodes(const FreeGoal& goal, const SearchEffort& effort,
                                                 const std::function<bool(const FreeSearchResult&)>& goes_on);

}  // namespace radcert
