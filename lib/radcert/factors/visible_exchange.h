// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/factors/facet_scene.h"

namespace radcert {

/// How far the integral over a receiver is driven.
struct CubatureDemand {
  double tolerance = 0;  ///< of the exchange area
  /// Cells of the receiver that are made, at most, rounded up to the last refinement.
  std::size_t most_cells = 8192;
};

/// The direct exchange area of two triangles between which others may stand, in doubles.
/// Maths     Int_{A_1} f(P) dS / pi, f(P) the flux of what P sees of the other: SourceViewer. The receiver is
///           the smaller of the two, cut into triangles. Where SightEvents lists nothing that may hide,
///           exchange_area serves; where the source is hidden, the integral is 0. On another cell f = g + d,
///           g analytic and 0 <= |d| <= c, the change of its events: a product Gauss rule with positive
///           weights errs by its error on g, for which four times the difference from the rule of the next
///           lower order stands, and on d, which begins at the event, by at most rule_error_on_kinks c. Where
///           c is not less than the unoccluded flux, the cell's integral lies between 0 and that without
///           screens, exchange_area: the middle is taken, with the half as error
/// Source    SightEvents. The cell with the largest error is taken up next: cut along its lines, where these
///           are few, else into four; without events a rule of higher order comes first
/// Requires  a pair of this scene; tolerance > 0
/// Result    value; radius: the sum of the errors of all cells, those of exchange_area and a bound of
///           rounding, at least the tolerance where rules were needed; an estimate, for the errors on g are.
///           At most about the tolerance, unless the cells are used up: then it is what was reached, and
///           covers the cells that were not cut. The same bits for any number of threads
/// Limits    the difference of two rules may be less than a quarter of the error by chance
[[nodiscard]] Approximation visible_exchange_area(const FacetScene& scene, const FacetPair& pair,
                                                  const CubatureDemand& demand);

/// How far the product Gauss rules of orders 3 and 5 may be off where a function begins on one side of a
/// line.
/// Maths     sup over D, linear and at most 1 on the triangle, of |rule - integral| of max(D, 0), in areas;
///           of max(D, 0)^2 it is less
/// Source    searched over the values of D at the corners: 0.0860 and 0.0393, for the squares 0.0601 and
///           0.0273
/// Requires  order 3 or 5
/// Result    a bound, rounded up
[[nodiscard]] constexpr double rule_error_on_kinks(int order) { return order == 3 ? 3.0 / 32 : 1.0 / 24; }

/// The same for one point of view: f(P) of what P with this unit normal sees of a polygon past occluders of
/// the scene, without 1/pi.
[[nodiscard]] double visible_flux(const FacetScene& scene, const Vector<double>& point,
                                  const Vector<double>& unit_normal, const FacetCorners& source,
                                  const std::vector<std::size_t>& occluders);

}  // namespace radcert
