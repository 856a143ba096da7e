// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/factors/facet_scene.h"

namespace radcert {

/// How far the integral over a receiver is driven.
struct CubatureDemand {
  double tolerance = 0;           ///< of the exchange area
  std::size_t most_cells = 4096;  ///< triangles of the receiver that are bisected in four, at most
};

/// The direct exchange area of two triangles between which others may stand, in doubles.
/// Maths     Int_{A_1} f(P) dS / pi, f(P) = 1/2 sum of Gamma n.m over the sides of what P sees of the other: its part in front, minus for
///           each occluder what lies in the pyramid from P over it and beyond its plane, cut convex piece by convex piece
/// Source    f: Lambert's flux of a polygon. The receiver, the smaller of the two, is divided into four where a product Gauss rule and
///           its four children differ most: f has kinks along lines where a side of one covers a corner of another, on which cells
///           shrink
/// Requires  a pair of this scene with sight mixed or whole; tolerance > 0
/// Result    value; radius: the sum of those differences, at least twice the tolerance, an estimate, and rounding. Half the sum is at
///           most the tolerance unless the cells are used up. The same bits for any number of threads
/// Limits    shadows that fall between the points of the rules are missed, without a sign of it. Pieces are cut in doubles: f is right to some 1e-15, however the pieces fall
[[nodiscard]] Estimate visible_exchange_area(const FacetScene& scene, const FacetPair& pair,
                                             const CubatureDemand& demand);

/// The same for one point of view: f(P) of what P with this unit normal sees of a polygon past occluders, without 1/pi.
[[nodiscard]] double visible_flux(const Vector<double>& point, const Vector<double>& unit_normal,
                                  const FacetCorners& source,
                                  const std::vector<const ConvexOccluder*>& occluders);

}  // namespace radcert
