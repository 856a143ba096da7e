// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/quadrature/collocation_point.h"
#include "radcert/study/problem.h"

namespace radcert {

/// The values of a piecewise expression at the collocation nodes.
/// Maths     f(v_i)
/// Source    [ac98, (40)]
/// Requires  an expression for every piece of the surface; `pointer` is the expression's place in the problem
///           file; `first` is the number of the first node
/// Result    finite values; otherwise InputError naming the node: its number, piece and coordinates
std::vector<double> values_at_nodes(const PiecewiseExpression& function, const std::string& pointer,
                                    const Surface& surface, std::span<const CollocationPoint<double>> nodes,
                                    std::size_t first = 0);

/// Bounds of the rounding errors of a piecewise expression at the collocation nodes.
/// Maths     |f(v_i) - values_i|, v_i the node of exact parameters, whose coordinates are off by no more than
///           8 u of the largest, on plane charts by 8 u of the numbers that they are summed up from
/// Source    interval arithmetic: the expression in balls about the rounded coordinates
/// Requires  values from values_at_nodes
/// Result    a radius a node; nothing where an expression is not proved to have a value at a node
/// Limits    a bound if the chart's own formula loses no more than 8 u
std::optional<std::vector<double>> value_radii(const PiecewiseExpression& function, const Surface& surface,
                                               std::span<const CollocationPoint<double>> nodes,
                                               std::span<const double> values);

/// The reflectivity at the collocation nodes.
/// Maths     rho(v_i)
/// Source    [ac98, (1)]
/// Requires  as values_at_nodes
/// Result    values in [0,1]; otherwise InputError naming the node
std::vector<double> reflectivity_at_nodes(const PiecewiseExpression& reflectivity, const Surface& surface,
                                          std::span<const CollocationPoint<double>> nodes,
                                          std::size_t first = 0);

}  // namespace radcert
