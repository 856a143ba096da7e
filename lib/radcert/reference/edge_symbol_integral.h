// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::reference {

/// The second route to the symbol of K at an edge: its integral.
/// Maths     k(b) = (1/2) sin^2(w) Int_0^inf t^(1+b) g(t) dt, g(t) = (1 - 2 c t + t^2)^(-3/2), c = cos(w).
///           With 1/t for t beyond 1 it is the integral of (t^(1+b) + t^(-b)) g(t) over 0 < t < 1. For t <
///           1/2 is g = sum p_n t^n, (n+1) p_(n+1) = (2n+3) c p_n - (n+2) p_(n-1), p_0 = 1, and |p_n| <=
///           (n+1)(n+2)/2, which integrates to sum p_n (1/2)^e/e with e = n+2+b and e = n+1-b: that continues
///           k to all b that are no whole numbers. The rest is an integral over [1/2, 1]
/// Source    Gegenbauer polynomials of index 3/2: DLMF 18.9.1, 18.12.4, 18.14.4; integral_on_interval
/// Requires  0 < angle < pi, certainly so, else ContractViolation
/// Limits    the precision must leave the digits of the radius
class EdgeSymbolIntegral {
public:
  explicit EdgeSymbolIntegral(const Ball& angle);

  /// k(b), or with derivative = 1 its derivative, for all b of the operand.
  /// Maths     from N >= 3 + |Re b| on the terms and their derivatives are at most 8 (N+1)(N+2) 2^(|Re b| -
  ///           N): |e| >= 1, |p_n| 2^-n shrinks by 3/4 at least, and |d/db (1/2)^e/e| <= (1/2)^Re(e) (log 2 +
  ///           1)
  /// Result    radii of at most 2 radius and what the operand's width and rounding make, or why not
  [[nodiscard]] Outcome<ComplexBall> at(const ComplexBall& b, int derivative, double radius) const;

  /// At least |k''| on the disk |z - b| <= by, by <= 1/8 and less than half the distance of b to whole
  /// numbers.
  /// Maths     each term has (1/2)^e (L^2/e - 2 L/e^2 + 2/e^3), L = -log 2, with |e| at least that of b less
  ///           `by`; the integral is at most (1/2) L^2 (2^(1 + |Re b| + by)) sup g, g <= 1/sin^3(w)
  [[nodiscard]] Ball second_derivative_bound(const ComplexBall& b, const Ball& by) const;

private:
  Ball cosine_;
  Ball sine_;
};

/// A zero of R k(b) - sign, by the integral alone.
/// Maths     |f(m)| + r^2/2 sup |f''| < |f'(m)| r, f = R k - sign: by Rouche's theorem, against f(m) +
///           f'(m)(z - m), there is exactly one zero with |z - m| < r. A real m has a real one, as f is real
///           there
/// Requires  R = sqrt(scale_squared) > 0, sign 1 or -1, a start that is no whole number, radius > 0
/// Result    the disk in a rectangle, found by Newton's method within 1/4 of the start, r <= radius; or why
///           not
[[nodiscard]] Outcome<ComplexBall> edge_zero_near(const Rational& degrees, const Rational& scale_squared,
                                                  int sign, const ComplexBall& start, const Rational& radius);

}  // namespace radcert::reference
