// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/nodal_function.h"
#include "radcert/study/study.h"

namespace radcert {

/// The values of a level of collocation at its nodes, in the order of collocation_nodes.
struct CollocationValues {
  std::span<const Approximation> u_n;  ///< all with a radius, or none
  std::span<const double> emission;
  std::span<const double> u;  ///< empty without `solution`
};

/// What is said of u_n in numbers, its values at the nodes known within a radius or not: describe_numbers,
/// and with a radius the solution_radius and the radius of the means that follows from it.
/// Result    fills these fields of the result of this level and no others
/// Limits    rounded, not enclosed
void describe_numbers(const Problem& problem, const NodalFunction& u_n, const std::optional<double>& radius,
                      LevelResult& result);

/// The fields of a level of collocation: describe_fields.
/// Requires  a value a node; `outcome` is of this level
void describe_fields(const NodedSurface& data, const TriangleBasis<double>& basis,
                     const CollocationValues& values, LevelOutcome& outcome);

/// Both: the description of u_n once its values at the nodes are known, their radius the largest.
void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome);

}  // namespace radcert
