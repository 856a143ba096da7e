// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/quadrature/collocation_point.h"
#include "radcert/study/study.h"

namespace radcert {

/// K u at points of a surface.
/// Maths     rho(P)/pi Int_S G(P,Q) u(Q) dS_Q
/// Source    [ac98, (2)]
/// Result    plain data, a number a point; radius as the route says, infinite where nothing bounds it
struct OperatorAtNodes {
  std::vector<double> value;
  std::vector<double> radius;
};

/// K u at points by the second route.
/// Maths     rho(P_i)/pi times what the route gives at P_i
/// Requires  a problem with a solution; a reflectivity for each node
/// Result    the same bits for any number of threads
/// Limits    as the route says
[[nodiscard]] OperatorAtNodes apply_operator(const Problem& problem, const Surface& surface,
                                             const OperatorRoute& route,
                                             std::span<const CollocationPoint<double>> nodes,
                                             std::span<const double> rho);

}  // namespace radcert
