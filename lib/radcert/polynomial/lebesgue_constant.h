// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/work_limit.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/inset_family.h"

namespace radcert {

/// Unless a caller says otherwise.
extern const WorkLimit most_lebesgue_triangles;

/// A number between two others, and how it was found.
struct LebesgueConstant {
  Rational lower;
  Rational upper;
  Barycentric<double>
      near;            ///< a point where the Lebesgue function is at least `lower`, with rounded coordinates
  long triangles = 0;  ///< how many were looked at
  bool reached = false;  ///< whether upper - lower <= tolerance
};

/// The Lebesgue constant of a node set on a triangle: the norm of interpolation there, enclosed.
/// Maths     Lambda = max over the closed triangle of sum_j |l_j(x)|.  On a part of it with the Bernstein
///           coefficients c_kj of l_j:  sum_j |l_j| <= max_k sum_j |c_kj|, with equality at the corners.
///           Parts whose bound exceeds the largest corner by more than the tolerance are halved, by de
///           Casteljau's algorithm at the middle of the longest side
/// Source    the norm: [ac98, (37)]; Bernstein coefficients: Farin, "Curves and surfaces for CAGD"
/// Requires  tolerance > 0, triangle_limit >= 1, else ContractViolation
/// Result    lower <= Lambda <= upper, proved: halving takes means only, and these are whole numbers times a
///           power of 2 whose roundings are counted. Where no l_j changes its sign the bound is within O(h^2)
/// Limits    not reached where the limit ends the search (the enclosure holds all the same), or where the
///           tolerance is below 10^-30 times the largest |c_kj|
[[nodiscard]] LebesgueConstant lebesgue_constant(const LagrangeFunctions& functions,
                                                 const Rational& tolerance,
                                                 long triangle_limit = most_lebesgue_triangles.value());

/// The Lebesgue constant of linear interpolation at the inset nodes, for all insets at once.
/// Maths     Lambda(alpha) = (1 + alpha)/(1 - 3 alpha), 0 <= alpha < 1/3
/// Source    [ac98, (37)]
/// Result    exact, and derived: sum |l_i| is convex, as each l_i is affine, so a vertex attains its maximum;
///           there each numerator of l_i has one sign on the whole of 0 < alpha < 1/3 by Sturm's theorem; the
///           sums at the vertices agree
/// Limits    ContractViolation if one of these steps were to fail
[[nodiscard]] InsetFunction linear_lebesgue_constant();

}  // namespace radcert
