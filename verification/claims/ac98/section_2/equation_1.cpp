// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      that (1) with the kernel (2), the inner normals and the factor rho/pi is the equation that the
//              library's integrals belong to: its two sides agree for solutions known beforehand, on the
//              sphere, where Int G u is pi times the mean of u, and on the cube, where u = 1 belongs to E = 1
//              - rho. At points, with enclosed integrals.
// Not checked  V: it is 1 here.

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding equation_1(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-8 : 1e-20;
  const BallPrecision precision(192);
  Finding finding;
  const AgreesWith zero{.value = Ball(0), .within = 4 * radius};
  for (const SphereSolution& each : linear_sphere_solutions()) {
    const bool varying = each.reflectivity.degree() > 0;
    if (bench.budget != Budget::full && !varying) continue;
    finding.require("u - rho/pi Int G u - E at a point of the sphere, " + each.name, zero,
                    sphere_residual(each, Ball(1), radius));
    finding.control("u - rho Int G u - E, without 1/pi, " + each.name, zero,
                    sphere_residual(each, Ball::pi(), radius));
  }
  const Polyhedron cube = cube_polyhedron();
  const Rational rho(3, 4);
  const AgreesWith constant{.value = Ball(1 - rho), .within = 1e-30};
  for (std::size_t face = 0; face < cube.faces.size(); ++face)
    for (const Vector<Rational>& p : random_face_points(cube.faces[face], 2, 11 + face)) {
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
