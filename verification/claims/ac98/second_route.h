// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

/// A figure of Tables 1 to 5 without the pipeline's quadrature, assembly, basis or solver, and without the
/// cubature behind E.
/// Maths     r_i = rho/pi Int G (u - P_n u) at the nodes, element by element: "discretisation_error" is max
///           |r_i|. "node_error" is max |e_i|, e = r + A e with A_ij = rho/pi Int G l_j, by fixed-point
///           iteration. Integrals by products of Gauss rules on triangles, which are divided in four wherever
///           two such rules differ. With interpolated geometry r_i is Ku over S less K P_n u over the
///           interpolant, and A is that of the interpolant
/// Source    [ac98, (33)-(40), (49)]; l_j written out here once more
/// Requires  a problem with `solution`, degree 0 or 1, triangulation without options, data on the surface,
///           else ContractViolation
/// Result    radius: what the two rules differ by, summed over the triangles; for the node error times the
///           largest row sum of (I - |A|)^-1. Stored
/// Limits    an estimate of about 1e-6 of the figure; shares charts, interpolants, triangles and the formula
///           of G with the pipeline
[[nodiscard]] Approximation second_route(const Bench& bench, const Problem& problem, int level,
                                         const std::string& figure);

}  // namespace radcert::verification::ac98
