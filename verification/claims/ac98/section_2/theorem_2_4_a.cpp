// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      on the sphere, with data for which u is known exactly: norm of u <= norm of E / (1 - norm of
//              K), norm of K = norm of rho there; equality for constant E and rho, and in no other of the
//              cases. u = 1 for E = 1 - rho on the cube. Uniqueness rests on (16), which the theorem does not
//              repeat: for rho = 1 every constant solves the equation with E = 0 on a closed surface, which
//              the check rejects; and no E of mean other than zero has a solution on the sphere, as the mean
//              of K u is that of u.
// Not checked  (b).

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding theorem_2_4_a(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-8 : 1e-20;
  const BallPrecision precision(192);
  Finding finding;
  const SphereSolution half = linear_sphere_solutions().at(4);  // one that is in all budgets
  finding.require("u - rho/pi Int G u - E at a point of the sphere, " + half.name,
                  AgreesWith{.value = Ball(0), .within = 4 * radius}, sphere_residual(half, Ball(1), radius));
  finding.control("the same with a seventh of the integral",
                  AgreesWith{.value = Ball(0), .within = 4 * radius},
                  sphere_residual(half, Ball(Rational(1, 7)), radius));
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
  const Polyhedron cube = cube_polyhedron();
  const Ball mean =
      total_factor(cube, floor_face, {Rational(1, 3), Rational(1, 5), 0}, 1 / power(Rational(10), 30)) /
      Ball::pi();
  const AtMost clearly_below_zero{
      .value = -0x1p-20, .slack = 0, .why = "u = 1 must not solve the equation with E = 0"};
  for (const Rational& below_one : {Rational(1, 10), Rational(99, 100)})
    finding.require("-(u - K u) for u = 1 at a point of the cube, rho = " + below_one.to_text(),
                    clearly_below_zero, proved(Ball(below_one) * mean - Ball(1)));
  finding.control("-(u - K u) for u = 1 at a point of the cube, rho = 1, against (16)", clearly_below_zero,
                  proved(mean - Ball(1)));
  return finding;
}

}  // namespace radcert::verification::ac98
