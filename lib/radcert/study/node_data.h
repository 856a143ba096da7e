// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "radcert/quadrature/observer.h"
#include "radcert/study/problem.h"

namespace radcert {

/// The values of a piecewise expression at the collocation nodes.
/// Maths     f(v_i)
/// Source    [ac98, (40)]
/// Requires  an expression for every piece of the surface; `pointer` is the expression's place in the problem file
/// Result    finite values; otherwise InputError naming the node: its number, piece and coordinates
/// Limits    -
std::vector<double> values_at_nodes(const PiecewiseExpression& function, const std::string& pointer,
                                    const Surface& surface, std::span<const Observer<double>> nodes);

/// The reflectivity at the collocation nodes.
/// Maths     rho(v_i)
/// Source    [ac98, (1)]
/// Requires  as values_at_nodes
/// Result    values in [0,1]; otherwise InputError naming the node
/// Limits    -
std::vector<double> reflectivity_at_nodes(const PiecewiseExpression& reflectivity, const Surface& surface,
                                          std::span<const Observer<double>> nodes);

}  // namespace radcert
