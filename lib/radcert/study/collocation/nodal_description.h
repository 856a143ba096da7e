// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"

namespace radcert {

/// The values of a level of collocation at its nodes, in the order of collocation_nodes.
struct CollocationValues {
  std::span<const double> u_n;
  std::span<const double> radius;  ///< of u_n; empty where nothing is proved
  std::span<const double> emission;
  std::span<const double> u;                             ///< empty without `solution`
  std::optional<double> solution_radius = std::nullopt;  ///< of u_n at every node; absent: not known
};

/// The description of u_n once its values at the nodes are known: describe_level, and with solution_radius
/// the means_radius that follows from it.
/// Requires  a value a node; `outcome` is of this level
/// Result    fills these fields of the outcome and no others
/// Limits    rounded, not enclosed
void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome);

}  // namespace radcert
