// SPDX-License-Identifier: GPL-3.0-or-later

// The hypothesis that S lies in the boundary of a convex body can be weakened. On an unoccluded surface a
// line through P meets S in at most one further point, or P would stand between two others: the directions of
// Q - P take at most one of w and -w, |G| dS_Q = |cos theta_P| dw, and Int |G| <= 1/2 Int |cos theta_P| over
// the whole sphere = pi.
//
// Checked      for all P at once: on two_piece (p = 2, 3) the largest integral, enclosed by branch and bound,
//              which is far below pi; on two_squares, where (22) is pi/2 less four angles that are positive
//              for all x and z > 0, with a lower bound by identities of rational functions of degree 8 at
//              most, and comes as close to pi/2 as z is small.
//              Equality on the cube, at points. The enclosures on two_piece against double integrals over the
//              library's charts.
// Not checked  other surfaces.

#include "radcert/closed_form/two_squares.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/scalar/dual.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// pi/2 - (22) = (atan(z/x) + atan(z/(1-x)))/2 + z/(2w) (atan(x/w) + atan((1-x)/w)), w^2 = 1 + z^2. For 0 < x
// < 1 and z > 0 all four angles are positive. More exactly: atan(t) - t/(1 + t^2) is 0 at t = 0 and has the
// derivative 2t^2/(1 + t^2)^2 >= 0, so that the first two parts are at least z/2 {x/(x^2 + z^2) +
// (1-x)/((1-x)^2 + z^2)} > 0. The supremum over z is pi/2, as all four tend to 0 with z.

// 1/(1 + t^2) less the derivative of t/(1 + t^2)^power.
Rational slope_of_difference(const Rational& at, int denominators) {
  const Dual<Rational> t(at, 1, 0);
  const Dual<Rational> square = Dual<Rational>(Rational(1)) + t * t;
  const Dual<Rational> quotient = denominators == 1 ? t / square : t / (square * square);
  return 1 / (1 + at * at) - quotient.by_s;
}

// A shelf in the cube that looks down at the floor: no part of the boundary of a convex body.
PlanePolygon shelf() {
  const Rational quarter(1, 4);
  const Rational half(1, 2);
  const Rational three(3, 4);
  return plane_polygon(
             {{quarter, quarter, half}, {quarter, three, half}, {three, three, half}, {three, quarter, half}})
      .value();
}

Ball over_two_piece(int p, std::size_t piece, const Rational& x, double radius) {
  return known(kernel_integral(ExactObserver::on_surface({{.chart = piece, .at = {x, Rational(1, 2)}}}),
                               two_piece(p), unit_density(), {.radius = radius}));
}

}  // namespace

Finding equation_15(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-3 : bench.budget == Budget::standard ? 1e-4 : 1e-6;
  const BallPrecision precision(192);
  Finding finding;
  for (const int p : {2, 3}) {
    const std::string of = ", two_piece(" + std::to_string(p) + ")";
    finding.require("largest integral of G over all P of the square, less pi" + of, AtMost{},
                    proved(largest_total_of_square(p, radius) - Ball::pi()));
    finding.require("largest integral of G over all P of the roof, less pi" + of, AtMost{},
                    proved(largest_total_of_roof(p, radius) - Ball::pi()));
    const Rational x(1, 3);
    finding.require("integral from (1/3,1/2,0), reduced to one dimension, against the chart's" + of,
                    AgreesWith{.value = over_two_piece(p, 0, x, 1e-9), .within = 1e-8},
                    total_of_square(p, x, 1e-10));
    finding.require("integral from the roof at x = 1/3, against the charts'" + of,
                    AgreesWith{.value = over_two_piece(p, 1, x, 1e-7), .within = 1e-6},
                    total_of_roof(p, x, 1e-10));
    finding.control("the same from x = 1/2" + of,
                    AgreesWith{.value = over_two_piece(p, 1, x, 1e-7), .within = 1e-6},
                    total_of_roof(p, Rational(1, 2), 1e-10));
  }
  const auto printed_slope = [](const Rational&, const Rational& at, const Rational&) {
    const Rational square = 1 + at * at;
    return 2 * at * at / (square * square);
  };
  const auto slope_with = [](int denominators) {
    return [denominators](const Rational&, const Rational& at, const Rational&) {
      return slope_of_difference(at, denominators);
    };
  };
  finding.require("points where the derivative of atan t - t/(1 + t^2) differs from 2t^2/(1 + t^2)^2",
                  IsExactly{0}, differing_points(slope_with(1), printed_slope));
  finding.control("points where that of atan t - t/(1 + t^2)^2 does", IsExactly{0},
                  differing_points(slope_with(2), printed_slope));
  finding.require("points where t/(1 + t^2) at t = z/x differs from zx/(x^2 + z^2)", IsExactly{0},
                  differing_points(
                      [](const Rational&, const Rational& at, const Rational& height) {
                        const Rational t = height / at;
                        return t / (1 + t * t);
                      },
                      [](const Rational&, const Rational& at, const Rational& height) {
                        return height * at / (at * at + height * height);
                      }));
  const Ball z(Rational(1, 5));
  const Ball x(Rational(1, 3));
  const Ball w = sqrt(Ball(1) + z * z);
  const Ball parts = (atan(z / x) + atan(z / (Ball(1) - x))) / Ball(2) +
                     z / (Ball(2) * w) * (atan(x / w) + atan((Ball(1) - x) / w));
  finding.require("pi/2 less these parts, against the closed form, x = 1/3, z = 1/5",
                  AgreesWith{.value = TwoSquares<Ball>(x, z).one(), .within = 1e-30},
                  Ball::pi() / Ball(2) - parts);
  finding.control("pi/2 less the first part alone, against the closed form",
                  AgreesWith{.value = TwoSquares<Ball>(x, z).one(), .within = 1e-30},
                  Ball::pi() / Ball(2) - (atan(z / x) + atan(z / (Ball(1) - x))) / Ball(2));
  const AgreesWith half_pi{.value = Ball::pi() / Ball(2), .within = 1e-15};
  const Ball middle(Rational(1, 2));
  finding.require("integral on two_squares, x = 1/2, z = 2^-60, against pi/2", half_pi,
                  TwoSquares<Ball>(middle, power(Ball(2), -60)).one());
  finding.control("integral on two_squares, x = z = 1/2, against pi/2", half_pi,
                  TwoSquares<Ball>(middle, middle).one());
  const Polyhedron box = cube_polyhedron();
  const Vector<Rational> floor_point{Rational(1, 2), Rational(1, 2), 0};
  const Ball on_cube = total_factor(box, floor_face, floor_point, Rational(1, 1L << 60));
  finding.require("integral on the cube, against pi", AgreesWith{.value = Ball::pi(), .within = 1e-15},
                  on_cube);
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  finding.control("integral on the cube with a shelf inside, V = 1, less pi", AtMost{},
                  proved(on_cube + point_to_polygon(floor_point, {0, 0, 1}, shelf(), one) - Ball::pi()));
  finding.show(proved(largest_total(2, radius)));
  return finding;
}

}  // namespace radcert::verification::ac98
