// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "radcert/closed_form/edge/edge_symbol.h"
#include "radcert/core/outcome.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Two plane faces that meet at an edge.
/// Requires  0 < angle < pi, made anew at the current precision; 0 <= reflectivity < 1 for both faces
struct Edge {
  std::function<Ball()> angle;   ///< the dihedral angle in radians
  bool is_right_angled = false;  ///< the angle is exactly pi/2
  Rational reflectivity;
  Rational other_reflectivity;
};

/// The edge whose dihedral angle has so many degrees. Requires 0 < degrees < 180, else ContractViolation
[[nodiscard]] Edge edge_of_degrees(const Rational& degrees, const Rational& reflectivity,
                                   const Rational& other_reflectivity);

/// An exponent b of the solution at an edge: u = u_0 + ... + c r^b + ...
/// Maths     a zero b of rho_1 rho_2 k(b)^2 = 1. With R = sqrt(rho_1 rho_2): R k(b) = 1 is symmetric, R k(b)
///           = -1 antisymmetric: the coefficients of r^b on the two faces are as sqrt(rho_1) to sqrt(rho_2),
///           or as sqrt(rho_1) to -sqrt(rho_2)
/// Result    imag() is exactly 0, or positive: then the conjugate is an exponent too
struct EdgeExponent {
  ComplexBall value;
  bool symmetric = true;
};

/// The smallest exponent of an edge.
/// Maths     the zero of R k(b) = 1 in 0 < b < 1. It is the only one there, as k(0) = cos^2(w/2) < 1/R, k
///           increases from b = -1/2 on, by k(b) = k(-1-b) and convexity, and tends to infinity at 1. No
///           other exponent has a real part between 0 and it, nor that real part: the integral of k has a
///           positive integrand, so |k(b)| <= k(Re b), with equality for real b alone
/// Source    ours; the exponents of such operators: J. Elschner, The double layer potential operator over
///           polyhedral domains I, 1992
/// Requires  0 < R, 0 < radius, else ContractViolation
/// Result    a ball of at most this radius, or why not
[[nodiscard]] Outcome<Ball> smallest_edge_exponent(const Edge& edge, const Rational& radius);

/// All exponents of an edge up to a given size.
/// Maths     all zeros with 0 < Re b <= up_to. H(b) = R pi x b (b+1) F - s sin(pi b), s = 1 or -1, is entire,
///           and vanishes where R k(b) = s, and at a whole n where k has no pole, which is known at right
///           angles for even n, or excluded. (a) For 0 <= Re b <= a with R k(a) < 1 there is none: |k(b)| <=
///           k(Re b) <= k(a). (b) For |Im b| > T there is none: |sin(pi b)| >= sinh(pi |Im b|), and as
///           (1-v^2) P_b'(v) = b (P_(b-1)(v) - v P_b(v)) and, by the integral of Mehler and Dirichlet,
///           |P_b(cos t)| <= cosh(t Im b) P_(-1/2)(cos t), P_(-1/2)(-cos w) = F(1/2,1/2;1;x) <= 1/sin(w/2), a
///           zero has sinh(pi |Im b|) <= R pi |b| cosh((pi-w) Im b)/sin(w/2), which fails at T and, if w
///           (up_to + T) >= 1, beyond: the quotient of the hyperbolic functions grows at the rate w at least,
///           |b| <= up_to + |Im b| at no higher one. (c) The rectangle that is left is cut into boxes until
///           in each H has no zero, by its values or its mean value form, or Krawczyk's operator maps a box
///           into its inside, so that there is exactly one. Zeros of boxes that overlap are one where either
///           lies in the other's box
/// Source    ours; R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, 2009, 8.2;
///           the integral: DLMF 14.12.1
/// Requires  0 < R, 0 < up_to, 1 <= digits, else ContractViolation
/// Result    ascending by real part, each within 10^-digits; or why they were not counted. `told`, if there
///           is one, is called with the part of the work that is done, ascending from 0 to 1
/// Limits    where exponents coincide, and where one cannot be told from up_to or from a whole number, no
///           answer. The rectangle is as high as 1/w, and the series are as slow as 1/w^2: below about 5
///           degrees, where they would take too many terms, no answer, before any of them is summed up
[[nodiscard]] Outcome<std::vector<EdgeExponent>> edge_exponents(const Edge& edge, const Rational& up_to,
                                                                int digits,
                                                                const std::function<void(double)>& told = {});

}  // namespace radcert
