// SPDX-License-Identifier: GPL-3.0-or-later

// On the unit sphere K u = rho M(u) with the mean M. Two solutions differ by a d with d = rho M(d), so that M(d)(1 -
// M(rho)) = 0, and d = 0 where M(rho) < 1. With e = norm of E, n = norm of rho: |u| <= e (1 + n/(1 - M(rho))), as
// |M(E)| <= e, and e/(1 - n) less that is e n (n - M(rho))/((1 - n)(1 - M(rho))) >= 0, as 0 <= M(rho) <= n.
//
// Checked      on the sphere for all data: the solution, and that difference, as identities of rational
//              functions. Data for which u is known exactly: equality for constant E and rho, and not for an E
//              that varies. Uniqueness rests on (16), which the theorem does not repeat: for rho = 1 every
//              constant solves the equation with E = 0 on a closed surface, see equation_17, and no E of mean
//              other than zero has a solution on the sphere, as the mean of K u is that of u.
// Not checked  surfaces other than the sphere: equation_18. (b).

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/sphere_algebra.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// e/(1 - n) - e (1 + n/(1 - r)), and e n (n - r)/((1 - n)(1 - r)) with a sign before r.
Rational data_without_the_bound(const Rational& sign) {
  constexpr long values = 4;
  using Three = std::array<Rational, 3>;
  return differing_on_grid<3>(
      values, [](const Three& x) { return x[0] / (1 - x[1]) - x[0] * (1 + x[1] / (1 - x[2])); },
      [&](const Three& x) { return x[0] * x[1] * (x[1] + sign * x[2]) / ((1 - x[1]) * (1 - x[2])); });
}

}  // namespace

Finding theorem_2_4_a(const Bench&) {
  Finding finding;
  require_solution_on_the_sphere(finding);
  finding.require("data where e/(1-n) - e (1 + n/(1-r)) differs from e n (n-r)/((1-n)(1-r))", IsExactly{0},
                  data_without_the_bound(-1));
  finding.control("data where it differs from e n (n+r)/((1-n)(1-r))", IsExactly{0},
                  data_without_the_bound(1));
  for (const SphereSolution& each : linear_sphere_solutions()) {
    const Rational of_u = largest_of_linear(each.solution);
    const Rational of_data = largest_of_linear(each.emission);
    const Rational bound = of_data / (1 - largest_of_linear(each.reflectivity));
    finding.require("norm of u - norm of E/(1 - norm of K), sphere, " + each.name, AtMost{},
                    proved(Ball(of_u - bound)));
    const bool constant = each.emission.degree() == 0 && each.reflectivity.degree() == 0;
    if (constant) {
      finding.require("norm of u, sphere, " + each.name, IsExactly{bound}, of_u);
      finding.control("norm of u - norm of E, sphere, " + each.name, AtMost{}, proved(Ball(of_u - of_data)));
    }
  }
  // Equality is for constant data: not for an E that varies.
  const Rational rho(13, 17);
  const SphereSolution varying =
      sphere_solution("", 1 - Rational(3, 7) * RationalPolynomial::variable(), rho);
  finding.control(
      "norm of u, sphere, E = 1 - 3 z^2/7, rho = 13/17, against the bound, which is for constant data",
      IsExactly{largest_of_linear(varying.emission) / (1 - rho)}, largest_of_linear(varying.solution));
  return finding;
}

}  // namespace radcert::verification::ac98
