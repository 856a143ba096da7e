// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/lagrange_functions.h"

namespace radcert {

/// The collocation matrix of a surface of plane elements, proved, with the reflectivity 1.
/// Maths     |entries(i, k p + j) - 1/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q| <= radius(i, k p + j), element k
///           the chart elements[k] over the unit triangle, its corners and nodes in the order of the chart's
///           parameters
/// Source    certified_entries with two corners of the elements exchanged whose orientation is against the
///           cross product, where the nodes are symmetric to that; else, and where the nodes are no doubles,
///           point_to_polygon_moments in balls
/// Requires  elements not degenerate; functions of degree at most 8, else ContractViolation
/// Result    radii as certified_entries; in balls about the rounding of the entry. Refused where balls of
///           4096 bits do not suffice. The same bits for any number of threads; Interrupted when asked to
///           stop
/// Limits    V = 1. Balls take a hundred to a thousand times as long. A node on another element's edge, off
///           its plane, is a ContractViolation
Outcome<CertifiedEntries> certified_plane_entries(std::span<const PlaneChart> elements,
                                                  const LagrangeFunctions& functions);

/// The same by balls alone.
Outcome<CertifiedEntries> plane_entries_in_balls(std::span<const PlaneChart> elements,
                                                 const LagrangeFunctions& functions);

/// A point of a plane chart with its normal.
struct PlaneNode {
  Vector<Rational> point;
  Vector<Rational> normal;  ///< not of unit length
};

/// The radiosity operator's integral of polynomials over plane charts, enclosed.
/// Maths     sum_j Int_{S_j} G(P,Q) q_j(Q) dS_Q, without 1/pi, q_j a polynomial in the parameters of chart j
/// Source    point_to_polygon
/// Requires  one domain and one polynomial of degree at most 8 a chart, else ContractViolation
/// Result    a ball for each point, of about the current precision. The same for any number of threads;
///           Interrupted when asked to stop
/// Limits    V = 1
std::vector<Ball> plane_operator(std::span<const PlaneChart> charts, std::span<const ChartDomain> domains,
                                 std::span<const PlanePolynomial<Rational>> density,
                                 std::span<const PlaneNode> points);

}  // namespace radcert
