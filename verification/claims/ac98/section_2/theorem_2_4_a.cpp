// SPDX-License-Identifier: GPL-3.0-or-later

// On the unit sphere K u = rho M(u) with the mean M. Two solutions differ by a d with d = rho M(d), so that
// M(d)(1 - M(rho)) = 0, and d = 0 where M(rho) < 1.
//
// Checked      on the sphere for all data: the solution and the bound, as identities of rational functions,
//              sphere_algebra.h. Data for which u is known exactly: equality for constant E and rho, and not
//              for an E that varies. Uniqueness rests on (16), which the theorem does not repeat: for rho = 1
//              every constant solves the equation with E = 0 on a closed surface, see equation_17, and no E
//              of mean other than zero has a solution on the sphere, as the mean of K u is that of u.
// Not checked  surfaces other than the sphere: equation_18. (b).

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/sphere_algebra.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding theorem_2_4_a(const Bench&) {
  Finding finding;
  require_solution_on_the_sphere(finding);
  require_norm_of_the_solution(finding);
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
