// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (15) on two_piece for p = 2, 3 and 3/2 and on two_squares, at collocation nodes and random
//              points; equality, which (15) allows, on the cube.
// Not checked  other surfaces; points closer to the border of a chart than a hundredth.

#include <numbers>
#include <vector>

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "verification/claims/ac98/surfaces/sample_points.h"
#include "verification/claims/ac98/surfaces/total_factor.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// The cube with a shelf in it that looks down: no part of the boundary of a convex body, and V = 1 counts the
// floor through the shelf.
Surface cube_with_a_shelf() {
  Surface surface = cube();
  surface.charts.push_back(make_rectangle(
      {.name = "shelf", .piece = "shelf", .orientation = Orientation::against_the_cross_product},
      {Rational(1, 4), Rational(1, 4), Rational(1, 2)}, {Rational(1, 2), 0, 0}, {0, Rational(1, 2), 0}));
  surface.diagonals.push_back(Diagonal::main);
  return surface;
}

struct NamedSurface {
  std::string name;
  Surface surface;
};

std::vector<NamedSurface> parts_of_convex_boundaries() {
  return {{"two_piece(2)", two_piece(2)},
          {"two_piece(3)", two_piece(3)},
          {"two_piece(3/2)", two_piece(Rational(3, 2))},
          {"two_squares", two_squares()},
          {"cube", cube()}};
}

}  // namespace

Finding corollary_2_2(const Bench& bench) {
  const std::size_t per_chart = bench.budget == Budget::quick      ? 12
                                : bench.budget == Budget::standard ? 60
                                                                   : 300;
  const AtMost at_most_pi{
      .value = std::numbers::pi, .slack = 1e-10, .why = "on the cube the two sides are equal"};
  Finding finding;
  for (const NamedSurface& each : parts_of_convex_boundaries()) {
    std::vector<SurfacePoint<double>> points = collocation_points(each.surface, 1, Rational(1, 6));
    for (const SurfacePoint<double>& p : random_points(each.surface, per_chart, 31)) points.push_back(p);
    finding.require("largest integral of G, " + each.name + ", " + std::to_string(points.size()) + " points",
                    at_most_pi, total_factors(each.surface, points).largest);
  }
  const Surface shelf = cube_with_a_shelf();
  finding.control("largest integral of G, the cube with a shelf inside", at_most_pi,
                  total_factors(shelf, random_points(shelf, 2, 32)).largest);
  return finding;
}

}  // namespace radcert::verification::ac98
