// SPDX-License-Identifier: GPL-3.0-or-later

// By directions, as in lemma_2_1: Int_S G is the integral of n_P.w over the directions w in which points of S
// with G != 0 are seen. Where (Q-P).n_P >= 0 for all P and Q, which is what it means for S to lie in the
// boundary of a convex body with its inner normals, G >= 0, and no direction shows two such points: with Q
// between P and Q', both (P-Q).n_Q and (Q'-Q).n_Q would be positive, in opposite directions. So the integral
// is at most pi, for all P.
//
// Checked      G dS_Q = n_P.w dw, an identity. (Q-P).n_P >= 0 for all P and Q: proved on two_piece for p = 2,
//              3 and 3/2, two_squares, the cube, which reaches pi, the sphere and the ellipsoid (1,2,5), by
//              the library's certificate; refuted by a pair of points for the cube with a shelf in it, where
//              the integral with V = 1 exceeds pi, see equation_15. section_1_two_piece_unoccluded: the same
//              inequality, of which G V = G is a consequence.
// Not checked  other surfaces.

#include <vector>

#include "radcert/hypotheses/convex_containment.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "verification/claims/ac98/surfaces/solid_angle.h"
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
          {"cube", cube()},
          {"sphere", sphere()},
          {"ellipsoid (1,2,5)", ellipsoid(1, 2, 5)}};
}

// 0 where (Q-P).n_P >= 0 is proved for all P and Q.
Rational not_proved(const Surface& surface) {
  return {convex_containment(surface).verdict == Containment::certified ? 0 : 1};
}

}  // namespace

Finding corollary_2_2(const Bench&) {
  Finding finding;
  require_kernel_by_directions(finding);
  for (const NamedSurface& each : parts_of_convex_boundaries())
    finding.require("1 where (Q-P).n_P >= 0 is not proved for all P and Q, " + each.name, IsExactly{0},
                    not_proved(each.surface));
  finding.control("1 where it is not, the cube with a shelf inside", IsExactly{0},
                  not_proved(cube_with_a_shelf()));
  return finding;
}

// Where (Q-P).n_P >= 0 for all pairs and a point X of S is between P and Q, both products at X are zero, so
// that X's plane, which has S on one side, contains P and Q: it is P's plane too, if P is off the border of
// its piece, and (Q-P).n_P = 0. So V = 0 only where G = 0: in the square, and along the rulings of the roof.
Finding section_1_two_piece_unoccluded(const Bench&) {
  Finding finding;
  for (const Rational& p : {Rational(2), Rational(3), Rational(3, 2)})
    finding.require("1 where (Q-P).n_P >= 0 is not proved for all P and Q, two_piece(" + p.to_text() + ")",
                    IsExactly{0}, not_proved(two_piece(p)));
  Surface between = two_piece(2);
  between.charts.push_back(make_rectangle({.name = "shelf", .piece = "shelf"},
                                          {Rational(1, 4), Rational(1, 4), Rational(1, 2)},
                                          {Rational(1, 2), 0, 0}, {0, Rational(1, 2), 0}));
  between.diagonals.push_back(Diagonal::main);
  finding.control("1 where it is not, two_piece(2) with a shelf between the pieces", IsExactly{0},
                  not_proved(between));
  return finding;
}

}  // namespace radcert::verification::ac98
