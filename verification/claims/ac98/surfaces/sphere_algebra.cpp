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
  constexpr long values = 9;  // degree 8 in each parameter
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

// Values of e, n and r where e/(1 - n) - e (1 + n/(1 - r)) is not e n (n + sign r)/((1 - n)(1 - r)).
Rational differing_bounds(const Rational& sign) {
  constexpr long values = 4;
  using Three = std::array<Rational, 3>;
  return differing_on_grid<3>(
      values, [](const Three& x) { return x[0] / (1 - x[1]) - x[0] * (1 + x[1] / (1 - x[2])); },
      [&](const Three& x) { return x[0] * x[1] * (x[1] + sign * x[2]) / ((1 - x[1]) * (1 - x[2])); });
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

void require_norm_of_the_solution(Finding& finding) {
  finding.require("norms where e/(1-n) - e (1 + n/(1-r)) differs from e n (n-r)/((1-n)(1-r))", IsExactly{0},
                  differing_bounds(-1));
  finding.control("norms where it differs from e n (n+r)/((1-n)(1-r))", IsExactly{0}, differing_bounds(1));
}

}  // namespace radcert::verification::ac98
