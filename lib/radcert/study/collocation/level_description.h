// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/problem.h"
#include "radcert/study/study.h"

namespace radcert {

/// The values of a level at its nodes, in the order of collocation_nodes.
struct LevelValues {
  std::span<const double> u_n;
  std::span<const double> radius;  ///< of u_n; empty where nothing is proved
  std::span<const double> emission;
  std::span<const double> u;                             ///< empty without `solution`
  std::optional<double> solution_radius = std::nullopt;  ///< of u_n at every node; absent: not known
};

/// What can be said of u_n once it is known.
/// Maths     uniform_error, piece_means and means_radius, the values at the nodes, and u_n at the corners of
///           the elements
/// Source    level_errors.h
/// Requires  a value a node; `outcome` is of this level
/// Result    fills these fields of the outcome and no others
/// Limits    rounded, not enclosed
void describe_level(const Problem& problem, const NodedSurface& data, const TriangleBasis<double>& basis,
                    const LevelValues& values, LevelOutcome& outcome);

}  // namespace radcert
