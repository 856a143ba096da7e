// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A function of two variables, in balls and in complex balls.
/// Requires  both enclose one function, which is real for real arguments
struct PlaneFunction {
  std::function<Ball(const Ball&, const Ball&)> in_balls;
  std::function<ComplexBall(const ComplexBall&, const ComplexBall&)> in_complex_balls;
};

/// From a formula: a class with  template <class R> R operator()(const R& s, const R& t) const, or a generic
/// lambda.
template <class Formula>
PlaneFunction plane_function(Formula formula) {
  return {.in_balls = [formula](const Ball& s, const Ball& t) -> Ball { return formula(s, t); },
          .in_complex_balls = [formula](const ComplexBall& s, const ComplexBall& t) -> ComplexBall {
            return formula(s, t);
          }};
}

/// [s_low, s_high] x [t_low, t_high].
struct ParameterRectangle {
  Rational s_low = 0;
  Rational s_high = 1;
  Rational t_low = 0;
  Rational t_high = 1;
};

/// A polynomial, and how far a function may be from it on a rectangle.
struct NearPolynomial {
  PlanePolynomial<Rational> polynomial;
  double distance = 0;  ///< at least sup |f - p|
  double size = 0;      ///< at least sup |p|
};

/// A polynomial of a total degree near a function that is analytic about a rectangle.
/// Maths     f = sum a_kl T_k(x) T_l(y), x and y the variables scaled to [-1,1]. Where f is analytic and |f|
///           <= M on the product of two Bernstein ellipses whose half axes sum to rho, |a_kl| <= 4 M
///           rho^-(k+l). The coefficients c_kl of the interpolant at N x N Chebyshev points are sums of a_kl
///           and of those that alias to it: with A_k = rho^-k + (rho^k + rho^-k) rho^-2N/(1 - rho^-2N) they
///           are off by 4 M (A_k A_l - rho^-(k+l)) at most. p has the c_kl of k + l <= d, rounded to double.
///           As |T_k| <= 1, what is left is at most the sum of |c_kl| for d < k + l <= D, what all of these
///           are off by, and 4 M sum_(n>D) (n+1) rho^-n
/// Source    L. N. Trefethen, "Approximation Theory and Approximation Practice", 2013, theorems 4.2 and 8.1
/// Requires  0 <= degree <= 16, a rectangle with an inside, else ContractViolation
/// Result    the distance by the best of some rho, proved; refused where f is not shown to be analytic about
///           the rectangle, or has no value at a point of it
/// Limits    M is the largest value on boxes that cover both ellipses, not the supremum. As good as f allows
///           on the whole rectangle: a function that is smooth in parts wants them one by one
[[nodiscard]] Outcome<NearPolynomial> near_polynomial(const PlaneFunction& f, const ParameterRectangle& on,
                                                      int degree);

}  // namespace radcert
