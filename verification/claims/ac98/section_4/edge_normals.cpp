// SPDX-License-Identifier: GPL-3.0-or-later

// section_4_2_edges: where two pieces meet at an edge their normals differ, so that a node there has none of
// its own; for 0 < alpha < 1/3 no node lies on a side of its element.
//
// section_4_1_continuous: on a side of an element the interpolant of degree r is a polynomial of degree r of
// the side's parameter, and it depends on the r + 1 points of the side alone, as the Lagrange functions of
// all others vanish there. The element beyond the side has the same points and the same polynomial, where
// both belong to one chart or to charts that agree along the side up to an affine change of its parameter.
//
// Checked      section_4_2_edges: all edges of the cube; the coordinates of the nodes, for all alpha.
//              section_4_1_continuous: the Lagrange functions on a side, r = 1 to 6, at r + 2 points of it
//              each, which proves it for all; and two charts of one edge whose parameters differ by t -> t^2.
// Not checked  edges between curved pieces.

#include <algorithm>
#include <string>

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/real_zeros.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Whether two faces share two corners, and their normals one direction.
struct FacePairs {
  long meeting = 0;
  long with_one_normal = 0;
};

bool has_corner(const PlanePolygon& face, const Vector<Rational>& corner) {
  for (const PolygonLoop& loop : face.loops())
    for (const ParameterPoint<Rational>& at : loop)
      if (face.point(at) == corner) return true;
  return false;
}

FacePairs pairs(const std::vector<PlanePolygon>& faces, const std::vector<Vector<Rational>>& corners) {
  FacePairs result;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (std::count_if(corners.begin(), corners.end(), [&](const Vector<Rational>& corner) {
            return has_corner(faces[i], corner) && has_corner(faces[j], corner);
          }) != 2)
        continue;
      ++result.meeting;
      const Vector<Rational> turn = cross(faces[i].normal(), faces[j].normal());
      if (dot(turn, turn).sign() == 0) ++result.with_one_normal;
    }
  return result;
}

// The two triangles of the floor of the cube, as elements: one plane.
std::vector<PlanePolygon> halves_of_the_floor() {
  return {plane_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}).value(),
          plane_polygon({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}).value()};
}

// Values at points of the side x_1 = 0 of Lagrange functions of nodes off that side's row that are not 0, for
// the lattice of degree r moved inwards by alpha.
Rational not_vanishing(int r, const Rational& alpha) {
  const InsetFamily family(r);
  long count = 0;
  for (std::size_t node = 0; node < family.size(); ++node) {
    if (family.node(node)[0](0).sign() == 0) continue;
    for (int i = 0; i <= r + 1; ++i) {
      const Rational t(i, r + 1);
      if (family.value(node, {{0, t, 1 - t}})(alpha).sign() != 0) ++count;
    }
  }
  return {count};
}

// By how much the interpolants of degree r of an edge part where one element has the parameter t and the
// other t^2 of it: the edge (t, t^2, 0), at t = 1/5 of either parameter, in the direction across
// the chord of the first.
Rational gap_between_charts(int r, bool same_parameter) {
  // x and y of the interpolant at i/r of (g, g^2), at t.
  const auto at = [&](bool squared, const Rational& t) {
    std::array<Rational, 2> point{0, 0};
    for (int i = 0; i <= r; ++i) {
      Rational l = 1;
      for (int k = 0; k <= r; ++k)
        if (k != i) l *= (Rational(r) * t - k) / Rational(i - k);
      const Rational node(i, r);
      const Rational g = squared ? node * node : node;
      point[0] += l * g;
      point[1] += l * g * g;
    }
    return point;
  };
  // The curve of the first at the abscissa of the second: for r >= 2 it is the edge y = x^2, for r = 1 its
  // chord.
  const auto [x, y] = at(!same_parameter, Rational(1, 5));
  const Rational on_the_first = r == 1 ? x : x * x;
  return y - on_the_first;
}

}  // namespace

Finding section_4_2_edges(const Bench&) {
  Finding finding;
  const Polyhedron cube = cube_polyhedron();
  const FacePairs of_the_cube = pairs(cube.faces, cube.corners);
  finding.require("edges of the cube", IsExactly{12}, Rational(of_the_cube.meeting));
  finding.require("edges of the cube with one normal on both sides", IsExactly{0},
                  Rational(of_the_cube.with_one_normal));
  finding.control("diagonals of its floor with one normal on both sides", IsExactly{0},
                  Rational(pairs(halves_of_the_floor(), cube.corners).with_one_normal));
  const InsetFamily family(1);
  long zeros = 0;
  long zeros_at_no_inset = 0;
  for (std::size_t node = 0; node < family.size(); ++node)
    for (const RationalPolynomial& x : family.node(node)) {
      zeros += zeros_between(x, 0, Rational(1, 3));
      if (x(0).sign() == 0) ++zeros_at_no_inset;
    }
  finding.require("zeros of the nodes' coordinates in 0 < alpha <= 1/3", IsExactly{0}, Rational(zeros));
  finding.control("coordinates that are 0 at alpha = 0", IsExactly{0}, Rational(zeros_at_no_inset));
  return finding;
}

Finding section_4_1_continuous(const Bench&) {
  Finding finding;
  for (int r = 1; r <= 6; ++r) {
    const std::string of = ", r = " + std::to_string(r);
    finding.require("values of the other Lagrange functions on a side that are not 0" + of, IsExactly{0},
                    not_vanishing(r, 0));
    finding.control("the same for the lattice moved inwards by 1/10" + of, IsExactly{0},
                    not_vanishing(r, Rational(1, 10)));
    // Of a parabola the interpolant of degree 4 is exact in either parameter.
    if (r == 2 || r == 3)
      finding.control("gap beside an edge whose charts have the parameters t and t^2" + of, IsExactly{0},
                      gap_between_charts(r, false));
    finding.require("gap beside an edge whose charts have one parameter" + of, IsExactly{0},
                    gap_between_charts(r, true));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
