// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// Nodes and weights of a rule on an interval.
template <Field R>
struct IntervalRule {
  std::vector<R> nodes;  ///< ascending
  std::vector<R> weights;
};

/// The weight function of a Gauss rule on [0,1].
enum class IntervalWeight {
  one,       ///< Legendre
  variable,  ///< x dx: the Jacobian of a triangle collapsed at one vertex
};

/// Gauss rules on [0,1] for the weight 1 or x.
/// Maths     Int_0^1 f(x) w(x) dx ~ sum w_k f(x_k), exact for degree 2 points - 1; x_k = (1 + z_k)/2, z_k the
///           zeros of the Jacobi polynomial P^(0,b), b = 0 or 1;  w_k = 1/((1 - z_k^2) P'(z_k)^2)
/// Source    recurrence and weights of Jacobi polynomials; zeros by Newton's method with deflation
/// Requires  1 <= points <= 192, else ContractViolation
/// Result    double: computed in long double and rounded once, so nodes and weights are within one unit in
///           the last place; long double, Mpfr<50>: within 4 points^2 units, as the node next to 0 is a
///           difference; Ball: enclosed, at BallPrecision::current() and narrow: for the weight 1 from
///           legendre_rule; for x a zero of P for each node, proved by Newton's operator N(X) = z -
///           P(z)/P'(X) in X, and no zero for two of them
/// Limits    arithmetics: double, long double, Mpfr<50>, Ball
template <Real R>
IntervalRule<R> gauss_rule(int points, IntervalWeight weight);

extern template IntervalRule<double> gauss_rule<double>(int, IntervalWeight);
extern template IntervalRule<long double> gauss_rule<long double>(int, IntervalWeight);
extern template IntervalRule<Mpfr<50>> gauss_rule<Mpfr<50>>(int, IntervalWeight);
extern template IntervalRule<Ball> gauss_rule<Ball>(int, IntervalWeight);

/// The Gauss-Legendre rule on [-1, 1], enclosed.
/// Maths     the zeros x_k of the Legendre polynomial P_n, ascending, and w_k = 2 / ((1 - x_k^2) P_n'(x_k)^2)
/// Source    Arb's arb_hypgeom_legendre_p_ui_root: F. Johansson, M. Mezzarobba, "Fast and rigorous
///           arbitrary-precision computation of Gauss-Legendre quadrature nodes and weights", 2018
/// Requires  points >= 1, else ContractViolation
/// Result    enclosed at BallPrecision::current()
[[nodiscard]] IntervalRule<Ball> legendre_rule(int points);

}  // namespace radcert
