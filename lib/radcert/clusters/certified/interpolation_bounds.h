// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// The interpolation nodes of a degree as exact points of the closed triangle.
/// Maths     (1 - s - t, s, t), s and t the doubles given; 0 <= s, t and s + t <= 1 exactly
/// Source    interpolation_nodes, the second and third coordinates of which are taken, made smaller by a unit
///           in the last place where they sum to more than 1
/// Requires  0 <= degree <= largest_mode_degree, else ContractViolation
[[nodiscard]] const std::vector<ParameterPoint<double>>& exact_interpolation_nodes(int degree);

/// The barycentric coordinates of such a point in an arithmetic that encloses.
template <class R>
Barycentric<R> barycentric_of(const ParameterPoint<R>& x) {
  return {{R(1) - x.s - x.t, x.s, x.t}};
}

/// What interpolation on a triangle may do to the size of a function.
/// Maths     W the matrix ModeInterpolation::modes_of_values as stored, exact rational numbers; stored: sup_x
///           sum_a |sum_n W_na D_n(x)|. With V_an = D_n(x_a) at exact_interpolation_nodes, l = V^-T D are the
///           Lagrange functions of these nodes; exact: sup_x sum_a |l_a(x)|; mean_size[a]: the root of the
///           mean of l_a^2 over the triangle, which the mean of |l_a| does not exceed; inverse: the values z
///           of a polynomial belong to the modes V^-1 z = W z' with |z' - z| <= inverse max |z|
/// Source    Theorem. A polynomial q of degree p has max |q| <= max |q(x_s)| / cos(2 p d) if every point of
///           the triangle is, as (X_1^2, X_2^2, X_3^2), within the angle d < pi/(4p) of a sample x_s on the
///           sphere. Proof: on the great circle through the point with the largest |q| and the sample next to
///           it q is a trigonometric polynomial of degree p in twice the angle, and such a T with its maximum
///           at 0 has |T(a)| >= |T(0)| cos(p a) for |a| <= pi/p (M. Riesz). Applied to sum_a +-l_a for all
///           signs. Parseval for the means. With V W = I + Y and y the largest sum of |Y_ab| over b, the
///           functions W^T D are (I + Y^T) l, so that sum |l_a| <= sum |(W^T D)_a| / (1 - y), and V^-1 = W (I
///           + Y)^-1, where the sums of the sizes of (I + Y)^-1 - I over a row are at most y / (1 - y); its
///           columns have at most ||W_a|| + max ||W_b|| k y / (1 - y), k nodes
/// Requires  0 <= degree <= largest_mode_degree, else ContractViolation
/// Result    proved upper bounds, by running errors: about 1.2 times the constants; made once. mean_size in
///           the order of the nodes
struct InterpolationBounds {
  double stored = 0;
  double exact = 0;
  double inverse = 0;
  std::vector<double> mean_size;
};
[[nodiscard]] const InterpolationBounds& interpolation_bounds(int degree);

}  // namespace radcert
