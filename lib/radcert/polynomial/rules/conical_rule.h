// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/barycentric.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {

/// Points and weights on a triangle of area one half.
template <Field R>
struct TriangleRule {
  std::vector<Barycentric<R>> points;
  std::vector<R> weights;  ///< sum to 1/2, the area of the reference triangle
};

/// Towards what a conical rule is graded, for integrands that are not analytic there.
enum class Grading {
  none,  ///< Gauss-Jacobi by Gauss-Legendre
  apex,  ///< towards vertex 1
  base,  ///< towards the side of vertices 2 and 3
};

/// Product rules on a triangle collapsed at its first vertex.
/// Maths     x = (1 - l, l (1 - t), l t),  d sigma = l dl dt;  `none`: Gauss rules in l (weight l) and t,
///           exact for degree 2 order - 1;  `apex`: l = m^8,  `base`: 1 - l = m^8, Gauss-Legendre in m with
///           twice the points: a power c^q of the distance from apex or base becomes m^(8q), smooth enough
///           for any q > 0
/// Source    conical products: Stroud; the power substitution: standard for algebraic end-point behaviour
/// Requires  1 <= order <= 96, else ContractViolation
/// Result    order^2 points (graded: twice as many, and at least 8 order, so that constants are exact), all
///           inside the triangle, weights positive. double: coordinates within 2^-51, weights within 24 units
///           in the last place; Mpfr<50>: as gauss_rule, and as many units; Ball: enclosed
/// Limits    not symmetric in the vertices
template <Real R>
TriangleRule<R> conical_rule(int order, Grading grading);

extern template TriangleRule<double> conical_rule<double>(int, Grading);
extern template TriangleRule<Mpfr<50>> conical_rule<Mpfr<50>>(int, Grading);
extern template TriangleRule<Ball> conical_rule<Ball>(int, Grading);

}  // namespace radcert
