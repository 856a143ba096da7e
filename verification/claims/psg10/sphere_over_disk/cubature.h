// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/claims/psg10/sphere_over_disk/solution.h"

namespace radcert::verification::psg10 {

/// The right-hand sides of the two equations at one point, by cubature of the kernel itself.
/// Maths     beta Int D(Q) cos cos'/(pi d^2) dQ over the part of the disk that a point of the sphere sees,
///           and the same the other way round: cosines and distance from Cartesian coordinates, the azimuth
///           up to where the sphere's point turns away, the other variable in pieces between the panels' ends
///           and the horizon; double exponential rules in both. B and D under the integral are the solution's
///           values off its nodes, so that what is compared with a value has passed through both equations
/// Source    [psg10, (21)]; H. Takahasi, M. Mori, "Double exponential formulas for numerical integration",
///           1974
/// Requires  a point that the solution takes; 1 <= points_a_unit: the inverse of the rules' step
/// Result    the indirect radiance; the digits grow about in proportion to points_a_unit
/// Limits    shares with the solution the two equations and its values, no kernel, no rule, no interpolation
///           at that point. Arithmetics: double, Mpfr<50>
template <Real R>
[[nodiscard]] R indirect_on_sphere(const SphereOverDisk<R>& solution, const R& t, int points_a_unit);
template <Real R>
[[nodiscard]] R indirect_on_disk(const SphereOverDisk<R>& solution, const R& u, int points_a_unit);

extern template double indirect_on_sphere<double>(const SphereOverDisk<double>&, const double&, int);
extern template Mpfr<50> indirect_on_sphere<Mpfr<50>>(const SphereOverDisk<Mpfr<50>>&, const Mpfr<50>&, int);
extern template double indirect_on_disk<double>(const SphereOverDisk<double>&, const double&, int);
extern template Mpfr<50> indirect_on_disk<Mpfr<50>>(const SphereOverDisk<Mpfr<50>>&, const Mpfr<50>&, int);

}  // namespace radcert::verification::psg10
