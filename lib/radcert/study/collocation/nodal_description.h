// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"

namespace radcert {

/// The values of a level of collocation at its nodes, in the order of collocation_nodes.
struct CollocationValues {
  std::span<const Approximation> u_n;  ///< all with a radius, or none
  std::span<const double> emission;
  std::span<const double> u;  ///< empty without `solution`
};

/// The description of u_n once its values at the nodes are known: describe_level, and where they have radii
/// the solution_radius and the radius of the means that follows from it.
/// Requires  a value a node; `outcome` is of this level
/// Result    fills these fields of the outcome and no others
/// Limits    rounded, not enclosed
void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome);

}  // namespace radcert
