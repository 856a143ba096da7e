// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {

/// The imaginary part of the dilogarithm in the unit disk; on its rim this is Clausen's integral.
/// Maths     Im Li_2(r e^(i phi)) = sum_{n>=1} r^n sin(n phi) / n^2;  r = 1: Cl_2(phi) = -Int_0^phi log|2
///           sin(x/2)| dx
/// Source    Lewin, Polylogarithms and Associated Functions, 1981, chapters 4 and 5
/// Requires  0 <= radius <= 1 and a finite angle, else ContractViolation (Ball: a failure if the radius
///           certainly lies outside; a ball that reaches over an end stands for its part in [0, 1])
/// Result    double: within 6 units of the last place of the value, for angles in [-pi, pi]; Mpfr: rounded to
///           nearest but for ties within 2^-16 units of the last place; Ball: enclosed, with a radius of the
///           first order in those of radius and angle, finite also around the branch point z = 1
/// Limits    angles are reduced modulo 2 pi: digits of a large angle are lost as in sin. Mpfr goes through
///           exact rationals: it costs memory in proportion to the binary exponents
double dilogarithm_imaginary(double radius, double angle);
Mpfr<50> dilogarithm_imaginary(const Mpfr<50>& radius, const Mpfr<50>& angle);
Mpfr<100> dilogarithm_imaginary(const Mpfr<100>& radius, const Mpfr<100>& angle);
Ball dilogarithm_imaginary(const Ball& radius, const Ball& angle);

}  // namespace radcert
