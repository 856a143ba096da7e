// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "radcert/scalar/ball.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/framework/finding.h"

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
/// The largest |d_x| + |d_y| over points, d the way from a point.
[[nodiscard]] Rational reach(const std::vector<PlanarPoint>& points, const PlanarPoint& about);

/// 1 + norm of L at alpha = 1/6: 10/3, as the norm of I - L can be no larger.
/// Source    [ac98, (37)]
[[nodiscard]] Rational bound_of_the_remainder();

/// The constant of an inequality for alpha = 1/6 and a shape, all f and all Phi: the largest of
/// interpolation_factors times 10/3.
/// Maths     legs, square: |a|_1, |b|_1 and |d|_1 <= h. Any triangle of the diameter h: |a|_1 <= 2^(1/2) |a|
///           <= 2^(1/2) h, and from the centroid to the vertex v_1 it is ((v_1 - v_2) + (v_1 - v_3))/3, no
///           longer than (2/3) h. A parallelogram of two of them: from the centre to a corner it is (+-a +-
///           b)/2, no longer than h
/// Source    [ac98, (60), (65), (74), (75)]
/// Result    proved, as verification/claims/mean_value_bounds.h says; that what has to be integrated exactly
///           is, is for the caller to show
[[nodiscard]] Rational constant_with_legs();
[[nodiscard]] Rational constant_on_squares();
[[nodiscard]] Ball constant_on_triangles();
[[nodiscard]] Ball constant_on_parallelograms();

/// Requires the identities behind the last two constants, exactly, with a control.
void require_lengths(Finding& finding);

/// Requires that the constant of a right isosceles triangle (gained = 1) or a square (2) with sides in any
/// direction lies in a range: |a|_1, |b|_1 <= 2^(1/2) h, and the corners are h/2^(1/2) from the middle. The
/// control develops about a corner.
/// Source    as constant_with_legs; interpolation_factors for `gained`
void require_in_any_direction(Finding& finding, int gained, const LiesIn& range);

/// A sum of terms B(phi, f), B bilinear and otherwise unknown, in the names of its arguments.
/// Maths     add: the product of two linear combinations, expanded
/// Result    exact; terms with the coefficient 0 are not kept
class BilinearSum {
public:
  using Combination = std::map<std::string, int>;
  void add(const Combination& phi, const Combination& f, int factor = 1);
  /// Removes the terms with this f, and with this phi where one is given.
  void vanish(const std::string& f, const std::string& phi = {});
  [[nodiscard]] Rational size() const { return {static_cast<long>(terms_.size())}; }

private:
  std::map<std::pair<std::string, std::string>, int> terms_;
};

/// ", h = ..., corner (...)", where that is.
[[nodiscard]] std::string placed_at(const Rational& h, const PlanarPoint& by);

}  // namespace radcert::verification::ac98
