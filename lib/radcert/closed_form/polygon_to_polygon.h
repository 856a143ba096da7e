// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The configuration factor from one plane polygon to another, in closed form and enclosed.
/// Maths     F_12 = 1/(pi A_1) Int_{A_1} Int_{A_2} max(d.n_1, 0) max(-d.n_2, 0) / |d|^4 dS_2 dS_1,  d = P_2 -
///           P_1. By Stokes' theorem A_1 F_12 = 1/(4 pi) Sum_ij Int Int log|P - Q|^2 dP.dQ over the edges of
///           both contours, of which only the parts in front of the other polygon's plane are kept. Each of
///           these integrals is elementary where the edges are parallel or on lines that meet, and else needs
///           Clausen's integral and Im Li_2 besides
/// Source    contour form: Sparrow, A new and simpler formulation for radiative angle factors, 1963; the edge
///           integrals are derived in polygon_to_polygon.cpp
/// Result    an enclosure, at the current precision. F_12 is 0 exactly where no part of one polygon lies in
///           front of the other: in one plane, behind each other, back to back. Clipping, and whether edges
///           are parallel, meet or touch, is decided in exact arithmetic: an edge or a corner in common is no
///           special case
/// Limits    nothing stands between the polygons. F_12 is a small difference of large terms: at a distance D
///           of so many sizes about 10 + 2 log2 D bits are lost of the absolute value and 10 + 4 log2 D of
///           the relative one, and as many as the sine of the angle between two edges has zeros; see
///           polygon_to_polygon_within
[[nodiscard]] Ball polygon_to_polygon(const PlanePolygon& from, const PlanePolygon& to);

/// The same with a demanded radius.
/// Maths     |F_12 - midpoint| <= radius
/// Source    at_raised_precision
/// Requires  radius > 0, else ContractViolation
/// Result    a ball of at most that radius; refused if most_raised_bits do not suffice
/// Limits    as polygon_to_polygon
[[nodiscard]] Outcome<Ball> polygon_to_polygon_within(const PlanePolygon& from, const PlanePolygon& to,
                                                      const Rational& radius);

}  // namespace radcert
