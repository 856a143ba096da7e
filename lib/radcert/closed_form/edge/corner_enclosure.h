// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "radcert/core/outcome.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Two bounds of a number.
struct BallBounds {
  Ball lower;
  Ball upper;
};

/// The spectral radius of K_g between the faces of an octant, see octant_spectral_radius, enclosed.
/// Maths     A positive f with K_g f <= r f has r(K_g) <= r, and one with K_g f >= r f has r(K_g) >= r: K_g^n
///           f <= r^n f, and likewise. f is a step function of the angle on each face, and K_g f a sum of
///           closed forms: from the direction at the angle x from the axis that two faces share, with c =
///           cos(q), y = cos(x), nu = 1 + g and T(cos a) = sin(nu (pi-a))/sin(a), the kernel's integral over
///           the angles from 0 to q from that axis is sin(x)/(2 sin(pi g) y) (T(c y) - T(y)), as -sin(a) da =
///           cos(x) dc turns it into Int dT. T solves (1-z^2) T'' - 3 z T' + (nu^2-1) T = 0, so that its
///           coefficients have t_(k+2) = ((k+1)^2 - nu^2)/((k+1)(k+2)) t_k, which with t_0 = sin(nu pi/2) > 0
///           and t_1 = nu cos(nu pi/2) < 0 makes all but the first negative: the sums over y are convex in y.
///           Up to x = pi/4 K_g f is enclosed over the cells of f by balls, beyond by chords in y, above on a
///           cell itself and below on one beside it
/// Source    ours; L. Collatz, Einschliessungssatz fuer die charakteristischen Zahlen von Matrizen, 1942
/// Requires  0 < g < 1, reflectivities in (0, 1), 8 <= cells <= 4096, even, else ContractViolation
/// Result    proved, in the space of bounded functions; with equal reflectivities the bounds are some 3/cells
///           + 1/(g cells^2) apart. Where g or a reflectivity is so near to 0 or 1 that balls of the current
///           precision do not tell, the whole line
/// Limits    the less one face reflects the wider, as f then falls steeply towards the axis of the two others
[[nodiscard]] BallBounds octant_spectral_bounds(const std::array<Rational, 3>& reflectivities,
                                                const Rational& g, int cells);

/// The exponent of the solution at the corner of three faces at right angles, enclosed.
/// Maths     the g in (0, 1) at which that spectral radius is 1. By Hoelder's inequality the kernels of
///           K_g^n, and with their norms the spectral radius, are logarithmically convex in g (for matrices:
///           J. F. C. Kingman, A convexity property of positive matrices, 1961); and K_(-2-g) has the kernel
///           of K_g, by R -> 1/R. So r(K_g) does not fall from g = -1 on, and r(K_a) < 1 < r(K_b) leaves such
///           g between a and b alone. With a complex exponent |K_(g+it)| <= K_g: none has a real part in (0,
///           a]. As the edges' part of K_g has at most the spectral radius 1/2, 1 is an eigenvalue
/// Source    ours
/// Requires  reflectivities as above, 0 < radius < 1, else ContractViolation
/// Result    a ball of this radius, but for a rounding, proved; or why not: an exponent nearer than it to 0
///           or 1, below 1e-6, or one that needs more than 1024 cells. They suffice for 1/1000 where all
///           three reflectivities are 1/2, for 1/400 where they are 9/10 or 99/100, and not for 1/100 where
///           one of them is very small
[[nodiscard]] Outcome<Ball> enclosed_octant_exponent(const std::array<Rational, 3>& reflectivities,
                                                     const Rational& radius);

}  // namespace radcert
