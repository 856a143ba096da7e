// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/collocation/certified/certified_operator.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The collocation nodes of a triangulation by their exact parameters.
/// Maths     v_{k p + j} = F(x_1 v_1 + x_2 v_2 + x_3 v_3), x node j of the functions, v the vertices of
///           element k
/// Source    [ac98, (36)]
/// Result    exact, in the order of collocation_nodes
std::vector<SurfacePoint<Rational>> exact_collocation_nodes(const Triangulation& triangulation,
                                                            const LagrangeFunctions& functions);

/// The collocation matrix on curved charts, proved.
/// Maths     see CertifiedEntries; sum_j radius(i, j) <= demand |rho(v_i)| for every row i
/// Source    certified_kernel_sums
/// Requires  an unoccluded surface; a triangulation of it; functions of degree at most 8; a reflectivity a
///           node, finite and taken as exact; 0 < demand, else ContractViolation
/// Result    radii whose sum over a row is at most demand |rho|. Refused, with the reason, where that was not
///           reached: a demand below the roundings of double (about 1e-13), a chart that is not analytic on
///           an element, a node on the border of another chart's element. The same bits for any number of
///           threads; Interrupted when asked to stop
/// Limits    V = 1. Where all elements are plane, certified_entries is faster and its radii are smaller
Outcome<CertifiedEntries> certified_chart_entries(const Surface& surface, const Triangulation& triangulation,
                                                  const LagrangeFunctions& functions,
                                                  std::span<const double> reflectivity, double demand);

/// A collocation matrix, and the operator's integral of a density at its nodes.
struct CertifiedCollocation {
  CertifiedEntries matrix;
  CertifiedValues integrals;
};

/// Both at once, for the reflectivity 1.
/// Maths     see certified_chart_entries and certified_operator
/// Source    one density more beside the functions of the elements: the rules and their nodes are the same
/// Requires  as those; 0 < size, about the largest |u|
/// Result    the radii of a row sum up to at most demand, those of the integrals are at most pi size demand.
///           Refused as those
/// Limits    at the cost of the matrix alone, unless u is not analytic close to the elements
Outcome<CertifiedCollocation> certified_collocation(const Surface& surface,
                                                    const Triangulation& triangulation,
                                                    const LagrangeFunctions& functions,
                                                    const DensityFormula& u, double size, double demand);

}  // namespace radcert
