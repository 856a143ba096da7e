// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/complex_ball.h"

namespace radcert {

/// A value and its derivative with respect to the exponent.
struct SymbolValue {
  ComplexBall value;
  ComplexBall slope;
};

/// The symbol of K at an edge: how K between the two faces of an infinite wedge acts on powers of the
/// distance from the edge.
/// Maths     Faces at the dihedral angle w, 0 < w < pi. From a point of one face at the distance z from the
///           edge, the kernel G/pi of the other, integrated along the edge, is (1/2) sin^2(w) y z/d^3 with
///           d^2 = y^2 + z^2 - 2 y z cos(w): so K takes y^b to k(b) z^b,
///               k(b) = (1/2) sin^2(w) Int_0^inf t^(1+b) (1 + t^2 - 2 t cos(w))^(-3/2) dt,  -2 < Re b < 1,
///                    = x pi b (b+1)/sin(pi b) F(-b, b+1; 2; x),  x = cos^2(w/2),
///           with Gauss's F; the second line is the meromorphic continuation, with poles at whole numbers
///           only
/// Source    I. S. Gradshteyn, I. M. Ryzhik, Table of Integrals, 3.252.10, which has Legendre's P^-1_b(-cos
///           w); a proof: J(c) = Int_0^inf t^b (1 + t^2 - 2 t c)^(-1/2) dt, -1 < Re b < 0, is at the distance
///           1 the potential of the charge t^b on a half-line, at the angle whose cosine is c. As a function
///           in space it is harmonic off the half-line, homogeneous of degree b and regular on the opposite
///           half-line, hence a multiple of P_b(-c), and J(-1) = Int t^b/(1 + t) dt = -pi/sin(pi b) is the
///           factor. J'(c) is the integral of k, so k(b) = (pi/2) sin^2(w) P_b'(-cos w)/sin(pi b), and
///           P_b'(v) = (b (b+1)/(1 + v)) F(-b, b+1; 2; (1-v)/2), by Euler's transformation of F(1-b, b+2; 2;
///           .). Both sides are analytic in the strip
/// Requires  the angle in (0, pi), certainly so, else ContractViolation
/// Result    at the current precision
/// Limits    k(b) = k(-1-b), k(0) = x, and k is convex and positive for real b in the strip
class EdgeSymbol {
public:
  /// From the dihedral angle in radians.
  explicit EdgeSymbol(const Ball& angle);

  /// The entire function of b behind the symbol.
  /// Maths     sin(pi b) k(b)/pi = x b (b+1) F(-b, b+1; 2; x) and its derivative. With beta = b (b+1), F is
  ///           sum a_n x^n, a_0 = 1, a_(n+1) = a_n r_n, r_n = (n (n+1) - beta)/((n+1)(n+2)). For n >= N >=
  ///           |beta|/2 is |r_n| <= 1: the terms from N on sum up to at most |a_N| x^N/(1-x), their
  ///           derivatives by beta to at most (|a_N'| + |a_N|/(N+1)) x^N/(1-x), as the derivatives of r_n sum
  ///           up from N on to 1/(N+1)
  /// Result    contains both for all b of the operand; a failure where the series would be too long
  [[nodiscard]] SymbolValue entire(const ComplexBall& b) const;

  /// The symbol itself; a failure where b may be a whole number.
  [[nodiscard]] ComplexBall operator()(const ComplexBall& b) const;

  [[nodiscard]] const Ball& angle() const { return angle_; }
  /// How many terms of its series are taken at most.
  [[nodiscard]] static long most_terms();
  /// cos^2(w/2) = k(0).
  [[nodiscard]] const Ball& at_zero() const { return x_; }

private:
  Ball angle_;
  Ball x_;
  Ball complement_;  ///< 1 - x = sin^2(w/2)
};

}  // namespace radcert
