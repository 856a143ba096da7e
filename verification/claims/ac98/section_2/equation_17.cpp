// SPDX-License-Identifier: GPL-3.0-or-later

// G >= 0, so that the norm of K on C(S) is max_P rho(P)/pi Int G, at most norm of rho times k, k that of rho
// = 1. On a closed surface the integral is pi everywhere and the norm is that of rho: the bound is sharp
// there, for every rho, and (16) cannot be spared, as K 1 = 1 for rho = 1. On other surfaces it is not
// necessary; it can be all the same, as beside a hole in a face of the cube, where all directions of the
// half-sphere but none of the hole's are seen: it is in the plane of P.
//
// Checked      k <= 1, and so (17) for every rho: on two_piece (p = 2, 3) k is enclosed over all P; on convex
//              bodies and parts of their boundaries it is corollary_2_2. k = 1 on the cube, for all P off the
//              edges and at a point, and with a hole in the floor, seen from the floor, not from the ceiling.
//              (I - K) 1 = 0 there for rho = 1, which the last inequality rejects.
// Not checked  compactness.

#include "verification/claims/ac98/surfaces/face_angles.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

constexpr std::size_t ceiling_face = 1;

Polyhedron cube_with_a_hole_in_the_floor() {
  Polyhedron cube = cube_polyhedron();
  const Rational half(1, 2);
  const Rational three(3, 4);
  cube.faces.at(floor_face) =
      plane_polygon({0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                    {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{half, half}, {three, half}, {half, three}}})
          .value();
  return cube;
}

}  // namespace

Finding equation_17(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-3 : bench.budget == Budget::standard ? 1e-4 : 1e-6;
  const BallPrecision precision(128);
  Finding finding;
  const AtMost clearly_below_zero{.value = -0x1p-20, .slack = 0, .why = "(17) ends in a strict inequality"};
  Ball shown;
  for (const int p : {2, 3}) {
    const std::string of = ", two_piece(" + std::to_string(p) + ")";
    const Ball total = largest_total(p, radius);
    const Ball norm = total / Ball::pi();
    finding.require("norm of K - 1 for rho = 1" + of, clearly_below_zero, proved(norm - Ball(1)));
    finding.remark("norm of K for rho = 1" + of, proved(norm));
    if (p == 2) shown = norm;
  }
  const Polyhedron cube = cube_polyhedron();
  require_total_of_pi(finding, cube);
  const Rational radius_at_points = 1 / power(Rational(10), 30);
  const Rational third(1, 3);
  const auto mean = [&](const Polyhedron& body, std::size_t face, const Rational& z) {
    return total_factor(body, face, {third, Rational(1, 5), z}, radius_at_points) / Ball::pi();
  };
  const AgreesWith one{.value = Ball(1), .within = 1e-25};
  finding.require("norm of K for rho = 1 at a point, cube", one, mean(cube, floor_face, 0));
  const Polyhedron with_hole = cube_with_a_hole_in_the_floor();
  finding.require("the same beside a hole in the floor", one, mean(with_hole, floor_face, 0));
  finding.control("the same from the ceiling of the cube with that hole", one,
                  mean(with_hole, ceiling_face, 1));
  finding.control("norm of K - 1 for rho = 1, cube, which (16) excludes", clearly_below_zero,
                  proved(mean(cube, floor_face, 0) - Ball(1)));
  finding.show(proved(shown));
  return finding;
}

}  // namespace radcert::verification::ac98
