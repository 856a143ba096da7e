// SPDX-License-Identifier: GPL-3.0-or-later

// For rho = 1 the norm of K is the largest of (1/pi) Int G. On two_piece(2) it is below 1, so that I - K is
// invertible, as the paper has it; not, though, because the surface is not closed. Cut a hole into the floor
// of the cube: from the rest of the floor, where G = 0 between its own points, every direction still meets
// one of the other faces, and Int G is pi. So the norm of K is 1 there, on a surface that is not closed. It
// is below 1 where every point sees the hole, as on a sphere without a cap: G = 1/4, and the area is 2 pi (1
// + c), c the cosine of the cap's angle.
//
// Checked      section_5_not_closed: the norm of K on two_piece(2), enclosed over all P; Int G from a point
//              of the cube's floor beside the hole to all other faces, and from a point of the lid to all
//              faces but the hole; the norm on the sphere without a cap.
// Not checked  that I - K is invertible on the cube with the hole.

#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

constexpr std::size_t lid_face = 1;

// (1/pi) Int G from a point of a face of the cube over the other faces, the floor without its hole, the
// square from 1/4 to 3/4.
Ball beside_the_hole(std::size_t face, const Vector<Rational>& p, bool with_a_hole) {
  const Rational radius = 1 / power(Rational(10), 30);
  const Polyhedron cube = cube_polyhedron();
  Ball sum = total_factor(cube, face, p, radius);
  if (with_a_hole) {
    const Rational low(1, 4);
    const Rational high(3, 4);
    const PlanePolygon hole =
        plane_polygon({{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}).value();
    PlanePolynomial<Rational> one(0);
    one(0, 0) = 1;
    // Exactly 0 from a point of the floor.
    sum = sum - point_to_polygon_within(radius, p, cube.faces.at(face).normal(), hole, one).value();
  }
  return sum / Ball::pi();
}

}  // namespace

Finding section_5_not_closed(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-3 : 1e-6;
  const BallPrecision precision(128);
  Finding finding;
  const LiesIn below_one{0, Rational(999, 1000)};
  const Ball of_two_piece = largest_total(2, radius) / Ball::pi();
  finding.require("norm of K, rho = 1, two_piece(2)", below_one, of_two_piece);
  const Rational eighth(1, 8);
  finding.require("(1/pi) Int G from the floor of the cube, beside a hole in it", below_one,
                  beside_the_hole(floor_face, {eighth, eighth, 0}, true));
  finding.instead("(1/pi) Int G from the lid of that cube", below_one,
                  beside_the_hole(lid_face, {eighth, eighth, 1}, true));
  finding.control("(1/pi) Int G from the lid of the closed cube", below_one,
                  beside_the_hole(lid_face, {eighth, eighth, 1}, false));
  for (const Rational& cosine : {Rational(1, 2), Rational(99, 100)})
    finding.instead(
        "norm of K, rho = 1, unit sphere without a cap whose angle has the cosine " + cosine.to_text(),
        below_one, Ball((1 + cosine) / 2));
  finding.show(proved(of_two_piece));
  return finding;
}

}  // namespace radcert::verification::ac98
