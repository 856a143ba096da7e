// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"

namespace radcert {

/// The corners of a convex plane polygon, counterclockwise as seen from its front.
using FacetCorners = std::vector<Vector<double>>;

/// The direct exchange area of two convex plane polygons with nothing between them, in doubles.
/// Maths     A_1 F_12 = 1/pi Int_{A_1} Int_{A_2} cos_1 cos_2 / |P-Q|^2 dS_2 dS_1 = A_2 F_21. Near: by Stokes'
///           theorem 1/(4 pi) Sum over pairs of edges of (a.b) Int_0^1 I(s) ds with I(s) = Int_0^1 log|P_0 +
///           s a - Q_0 - t b|^2 dt = [ tau log(tau^2+rho^2) + 2 rho atan(tau/rho) ]_{tau_0}^{tau_0+|b|} /
///           |b|, up to constants that closed contours cancel. Far: product Gauss rules on both
/// Source    contour form: Sparrow, A new and simpler formulation for radiative angle factors, 1963. I is
///           analytic but where the line of a comes near an end or the line of b: there [0,1] is parted, and
///           bisected until Gauss rules of 8 points agree, where that is not by chance: on cells no longer
///           than their distance from such a place, or tiny ones
/// Requires  each polygon wholly in front of the other's plane, points of the plane allowed; at least three
///           corners
/// Result    value with radius an estimate of its error, rounding included: the difference of two rules near,
///           the rate of convergence on the Bernstein ellipse far. Symmetric in the two polygons up to
///           rounding
/// Limits    near: the value is a small difference of terms of the size of a side times the distance: about
///           2^-52 (diameter distance) is its least radius. far_ratio tells near from far
[[nodiscard]] Approximation exchange_area(const FacetCorners& first, const FacetCorners& second);

/// Beyond so many times the sum of their circumradii polygons are far: z below is 4 there for equal ones, and
/// rules of order 8 reach rounding.
inline constexpr double far_ratio = 2.5;

/// The two ways by themselves, for comparison: the contour form for all pairs, product rules for far ones
/// alone.
[[nodiscard]] Approximation exchange_area_by_contours(const FacetCorners& first, const FacetCorners& second);
[[nodiscard]] Approximation exchange_area_by_rules(const FacetCorners& first, const FacetCorners& second);

/// The centre of a polygon's corners and the largest distance of a corner from it.
struct Roundness {
  Vector<double> centre;
  double radius = 0;
};
[[nodiscard]] Roundness roundness(const FacetCorners& polygon);

/// Half the sum of the cross products of a polygon's corners: its area times its unit normal.
[[nodiscard]] Vector<double> vector_area(const FacetCorners& polygon);

}  // namespace radcert
