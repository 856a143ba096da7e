// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "radcert/scalar/approximation.h"

namespace radcert {

/// The spectral radius of K between the faces of an octant, on functions homogeneous about its corner.
/// Maths     K takes R^g f(angle) on the three faces to R^g (K_g f)(angle), R the distance from the corner:
///           with e, e' the directions of two faces with the normals n, n', cos(a) = e . e', K_g has the
///           kernel
///               (1/pi) (n . e')(n' . e) Int_0^inf R^(g+2)/(1 + R^2 - 2 R cos(a))^2 dR,
///           the integral being (pi/(2 sin(pi g) sin(a))) d/da (sin((1+g)(pi-a))/sin(a)). Each face's part is
///           multiplied by its reflectivity. For g = 0 and equal reflectivities rho it is 3 rho/4, that of
///           constants: of the half of the sky above a face the two others hide three quarters
/// Source    ours; the integral: I. S. Gradshteyn, I. M. Ryzhik, Table of Integrals, 3.252.12, differentiated
/// Requires  0 < g < 1, reflectivities in [0, 1), else ContractViolation
/// Result    by Nystrom's method on tanh-sinh nodes and power iteration; estimated from two numbers of nodes
[[nodiscard]] Approximation octant_spectral_radius(const std::array<double, 3>& reflectivities, double g);

/// The exponent of the solution at the corner of three faces at right angles.
/// Maths     the g in (0, 1) at which that spectral radius is 1, u = u_0(angle) + c R^g f(angle) + ...; 1
///           where it stays below
/// Source    ours
/// Requires  reflectivities in [0, 1), else ContractViolation
/// Result    estimated
/// Limits    no proof: see corner_enclosure.h. It may be smaller than the exponents of the three edges
[[nodiscard]] Approximation octant_exponent(const std::array<double, 3>& reflectivities);

}  // namespace radcert
