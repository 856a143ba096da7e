// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/factors/facet_scene.h"

namespace radcert {

/// How far the integral over a receiver is driven.
struct CubatureDemand {
  double tolerance = 0;           ///< of the exchange area
  std::size_t most_cells = 4096;  ///< triangles of the receiver that are taken up anew, at most
};

/// The direct exchange area of two triangles between which others may stand, in doubles.
/// Maths     Int_{A_1} f(P) dS / pi, f(P) = 1/2 sum of Gamma n.m over the sides of what P sees of the other:
///           its part in front, minus for each occluder what lies in the pyramid from P over it and beyond
///           its plane, cut convex piece by convex piece
/// Source    f: Lambert's flux of a polygon. The receiver is the smaller of the two, in receiver_cells. Where
///           no solid hides anything exchange_area serves, where one hides all the integral is 0. Else
///           product Gauss rules of orders 3 and 2: where they differ most, of orders 5 and 4, 3, then on
///           quarters. Where several solids cast shadows, f has kinks along curves at which these begin to
///           meet, or to hide everything together: on triangles at whose corners and middles of sides one or
///           the other is partly so, a share of its size joins the error
/// Requires  a pair of this scene with sight mixed or whole; tolerance > 0
/// Result    value; radius: the sum of the differences of rules, of those shares and rounding, an estimate;
///           that sum is at most the tolerance unless the cells are used up, the radius at least four times
///           the tolerance where rules were needed. The same bits for any number of threads
/// Limits    other changes of kind where shadows of several solids meet are seen by the rules' points or not
///           at all. Pieces are cut in doubles: f is right to some 1e-15, however the pieces fall
[[nodiscard]] Estimate visible_exchange_area(const FacetScene& scene, const FacetPair& pair,
                                             const CubatureDemand& demand);

/// The same for one point of view: f(P) of what P with this unit normal sees of a polygon past occluders of
/// the scene, without 1/pi.
[[nodiscard]] double visible_flux(const FacetScene& scene, const Vector<double>& point,
                                  const Vector<double>& unit_normal, const FacetCorners& source,
                                  const std::vector<std::size_t>& occluders);

}  // namespace radcert
