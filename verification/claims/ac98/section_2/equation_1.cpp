// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      that (1) with the kernel (2), the inner normals and the factor rho/pi is the equation whose
//              solutions are known. On the unit sphere for all data: G = 1/4 for all pairs, as an identity of
//              rational functions, so that Int G u/pi is the mean of u, and u = E + rho M(E)/(1 - M(rho)).
//              There as well by the library's charts and an enclosed integral. On the cube, where u = 1
//              belongs to E = 1 - rho, for all P off the edges: face_angles.h, and at points by the closed
//              form of a polygon.
// Not checked  V: it is 1 here.

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/face_angles.h"
#include "verification/claims/ac98/surfaces/sphere_algebra.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding equation_1(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-8 : 1e-20;
  const BallPrecision precision(192);
  Finding finding;
  require_solution_on_the_sphere(finding);
  const AgreesWith zero{.value = Ball(0), .within = 4 * radius};
  const SphereSolution varying = linear_sphere_solutions().back();
  const SphereParts parts = sphere_parts(varying, radius);
  finding.require("u - rho/pi Int G u - E at a point of the sphere, " + varying.name, zero,
                  parts.beyond_emission - parts.reflected);
  finding.control("u - rho Int G u - E, without 1/pi, " + varying.name, zero,
                  parts.beyond_emission - Ball::pi() * parts.reflected);
  require_total_of_pi(finding, cube_polyhedron());
  const Polyhedron cube = cube_polyhedron();
  const Rational rho(3, 4);
  const AgreesWith constant{.value = Ball(1 - rho), .within = 1e-30};
  for (std::size_t face = 0; face < cube.faces.size(); ++face)
    for (const Vector<Rational>& p : random_face_points(cube.faces[face], 1, 11 + face)) {
      const Ball total = total_factor(cube, face, p, 1 / power(Rational(10), 32));
      finding.require(
          "1 - rho/pi Int G at a point of the cube, face " + std::to_string(face) + ", against 1 - rho",
          constant, Ball(1) - Ball(rho) / Ball::pi() * total);
    }
  Polyhedron open = cube;
  open.faces.pop_back();
  const Rational half(1, 2);
  finding.control("the same on the cube without a wall", constant,
                  Ball(1) - Ball(rho) / Ball::pi() *
                                total_factor(open, floor_face, {half, half, 0}, 1 / power(Rational(10), 32)));
  return finding;
}

}  // namespace radcert::verification::ac98
