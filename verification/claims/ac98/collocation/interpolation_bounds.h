// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "verification/claims/ac98/surfaces/exact_plane.h"

namespace radcert::verification::ac98 {

/// An error of interpolation under an integral, and what bounds it.
/// Maths     error = |Int phi (I - L) f|;  bound <= [Int sum_(i<=k) |D^i phi|] max_(2<=i<=k+2) |D^i f|, |D^i
///           f| the largest derivative of order i;  k = 1: [ac98, (60)], k = 2: [ac98, (65)]
/// Source    [ac98, (60), (65)]
/// Result    exact; `bound` is from below, with the larger of the integrals for the integral of the larger,
///           and the vertices for the maximum: error > c h^p bound does not prove (60) wrong, error <= c h^p
///           bound proves it here
struct BoundedError {
  Rational error;
  Rational bound;
};

/// The errors of products of monomials.
/// Maths     phi of degree <= 3, f of degree <= 5, over the triangles; alpha = 1/6
/// Requires  a polygon that is the union of the triangles, in the quadrant x, y >= 0, where monomials and
///           derivatives are not negative
/// Result    exact, one for each product
[[nodiscard]] std::vector<BoundedError> bounded_errors(const std::vector<PlanarTriangle>& triangles,
                                                       const std::vector<PlanarPoint>& polygon,
                                                       int derivatives_of_phi);

/// How many errors exceed `factor` times their bounds.
[[nodiscard]] Rational exceeding(const std::vector<BoundedError>& errors, const Rational& factor);

/// The largest error/bound where the bound is not 0.
[[nodiscard]] Rational largest_ratio(const std::vector<BoundedError>& errors);

/// The points moved and stretched: `by` + h p.
[[nodiscard]] std::vector<PlanarPoint> placed(const std::vector<PlanarPoint>& points, const Rational& h,
                                              const PlanarPoint& by);
/// ", h = ..., corner (...)", where that is.
[[nodiscard]] std::string placed_at(const Rational& h, const PlanarPoint& by);

}  // namespace radcert::verification::ac98
