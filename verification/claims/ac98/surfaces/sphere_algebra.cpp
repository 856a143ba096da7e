// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/sphere_algebra.h"

#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/sample_points.h"

namespace radcert::verification::ac98 {
namespace {

using Four = std::array<Rational, 4>;

// Pairs of points of the unit sphere where G, with the normal at Q turned by `sign`, is not 1/4.
Rational pairs_with_another_kernel(const Rational& sign) {
  constexpr long values = 5;
  return differing_on_grid<4>(
      values,
      [&](const Four& x) {
        const Vector<Rational> p = sphere_point(x[0], x[1]);
        const Vector<Rational> q = sphere_point(x[2], x[3]);
        return geometric_kernel(p, -p, q, sign * -q);
      },
      [](const Four&) { return Rational(1, 4); });
}

// Data for which E + c rho does not solve (1), c with so many reflections, or all of them.
Rational unsolved_data(bool all_reflections) {
  constexpr long values = 3;
  return differing_on_grid<4>(
      values,
      [&](const Four& x) {
        const SphereEquation at(x);
        return at.residual(all_reflections ? at.multiple() : at.mean_emission);
      },
      [](const Four&) { return Rational(0); });
}

}  // namespace

void require_solution_on_the_sphere(Finding& finding) {
  finding.require("pairs of points of the unit sphere where G is not 1/4", IsExactly{0},
                  pairs_with_another_kernel(1));
  finding.control("the same with the outer normal at Q", IsExactly{0}, pairs_with_another_kernel(-1));
  finding.require("data for which u = E + rho M(E)/(1 - M(rho)) does not solve (1) on the sphere",
                  IsExactly{0}, unsolved_data(true));
  finding.control("data for which u = E + rho M(E), one reflection, does not", IsExactly{0},
                  unsolved_data(false));
}

}  // namespace radcert::verification::ac98
