// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "radcert/enclosure/demand.h"
#include "radcert/scalar/complex_ball.h"

namespace radcert {

/// A function of one variable, in real and in complex balls; see SquareFunction.
struct LineFunction {
  std::function<Ball(const Ball&)> in_balls;
  std::function<ComplexBall(const ComplexBall&)> in_complex_balls;
};

/// From a formula: a class with  template <class R> R operator()(const R& x) const, or a generic lambda.
template <class Formula>
LineFunction line_function(Formula formula) {
  return {.in_balls = [formula](const Ball& x) -> Ball { return formula(x); },
          .in_complex_balls = [formula](const ComplexBall& x) -> ComplexBall { return formula(x); }};
}

/// The integral of a function of one variable, enclosed.
/// Maths     Int_a^b f(x) dx
/// Source    Arb's acb_calc_integrate: F. Johansson, "Numerical integration in arbitrary-precision ball
///           arithmetic", 2018: adaptive bisection, Gauss-Legendre rules with the error bound of Bernstein
///           ellipses where f is analytic, the values on a real interval times its length elsewhere
/// Requires  radius > 0, work_limit >= 1, a and b finite, else ContractViolation; f real for real arguments,
///           both formulas enclose one function
/// Result    a ball of radius <= demand.radius, or undecided with what was reached
/// Limits    a singularity inside (a, b) is found by bisection alone: split there
[[nodiscard]] Enclosure integral_on_interval(const LineFunction& f, const Ball& a, const Ball& b,
                                             const Demand& demand);

}  // namespace radcert
