// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/collocation/certified/exact_nodes.h"
#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/lagrange_functions.h"

namespace radcert {

/// The matrix of K P_n with a proved radius for every entry.
/// Maths     |entries(i, k p + j) - rho(v_i)/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q| <= radius(i, k p + j), p
///           functions an element
/// Source    [ac98, (40)]
/// Result    made by certified_entries
/// Limits    dense
struct CertifiedEntries {
  Matrix<double> entries;
  Matrix<double> radius;
};

/// The requirements of the functions that fill such a matrix.
/// Requires  functions of degree at most 8; a reflectivity a node, finite, else ContractViolation
void expects_collocation_data(const LagrangeFunctions& functions, std::size_t nodes,
                              std::span<const double> reflectivity);

/// The collocation matrix of plane elements, proved.
/// Maths     see CertifiedEntries; the nodes v_{k p + j} = x_1 c_1 + x_2 c_2 + x_3 c_3 with the exact
///           coordinates x of node j, the normals those of the elements
/// Source    PlaneElement. The integrals have no dimension: in a unit of length in which nodes and corners
///           are whole numbers the nodes are doubles exactly, and the entries are those of the exact problem.
///           Int |G| = |Int G| on an element, where G has one sign, and Int G is the sum of the integrals, as
///           the l_j have the sum 1
/// Requires  elements not degenerate; functions of degree at most 8; a reflectivity a node, finite and taken
///           as exact, else ContractViolation
/// Result    radii of about 1e-14 max |l_j| of what the node sees of the element, times reflectivity/pi.
///           Refused where the coordinates of the nodes have no unit in which all are doubles, or the
///           functions do not have the sum 1 or are too large for the bound. The same bits for any number of
///           threads; Interrupted when asked to stop
/// Limits    nothing stands between a node and an element: V = 1, as within a convex enclosure. A node on
///           another element's edge, off its plane, as for nodes without inset, is a ContractViolation
Outcome<CertifiedEntries> certified_entries(std::span<const ExactTriangle> elements,
                                            const LagrangeFunctions& functions,
                                            std::span<const double> reflectivity);

}  // namespace radcert
