// SPDX-License-Identifier: GPL-3.0-or-later

// (12): m_k = F_j after the affine map (s,t) -> u v_1 + t v_2 + s v_3, u = 1 - s - t, of the unit simplex to
// the triangle of the parameter plane.
//
// Checked      equation_12: the library's map to the parameter plane against the printed one, exactly (points
//              and vertices are dyadic), at six points of every triangle of level 2 on two_piece and sphere;
//              a map of degree 1 is settled by three. Rejected: the numbering of [ac98, (29)], v_1 for v_3.
//              equation_12_one_to_one: its determinant is twice the triangle's signed area; each of the four
//              children has a quarter of that of its parent, an identity for all triangles, so that it is
//              positive at every level as it is for the coarse ones. Rejected: a triangle with its vertices
//              on a line, sides divided at a third. F_j is for equation_10_one_to_one.
//              equation_12_affine: m_k(1/2,1/2) is not the middle of m_k(1,0) and m_k(0,1) on an octant of
//              the sphere; it is on a face of the octahedron.
// Not checked  charts beyond the catalogue's domains.

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/m06/section_2/symmetric_refinement.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

enum class Numbering { of_m06, of_ac98 };

// u v_1 + t v_2 + s v_3, or s v_1 + t v_2 + u v_3.
Corner printed(const Triangle& v, const Rational& s, const Rational& t, Numbering numbering) {
  const Rational u = 1 - s - t;
  const bool as_here = numbering == Numbering::of_m06;
  Corner at;
  for (std::size_t c = 0; c < 2; ++c)
    at[c] = (as_here ? u : s) * v[0][c] + t * v[1][c] + (as_here ? s : u) * v[2][c];
  return at;
}

// Points, six a triangle, where the library's map is another one.
Rational points_apart(const Surface& surface, int level, Numbering numbering) {
  constexpr std::array<std::array<double, 2>, 6> points{
      {{0, 0}, {0, 1}, {1, 0}, {0.5, 0}, {0.25, 0.5}, {0.125, 0.125}}};
  long count = 0;
  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles) {
    Triangle exact;
    for (std::size_t i = 0; i < 3; ++i)
      exact[i] = {Rational::exactly(triangle.vertices[i].s), Rational::exactly(triangle.vertices[i].t)};
    for (const auto& [s, t] : points) {
      const ParameterPoint<double> at = triangle.at({1 - s - t, t, s});
      const Corner expected = printed(exact, Rational::exactly(s), Rational::exactly(t), numbering);
      if (Corner{Rational::exactly(at.s), Rational::exactly(at.t)} != expected) ++count;
    }
  }
  return {count};
}

// Four times the determinant of each child less that of the parent, any triangle.
Rational terms_of_quarters(const Rational& part) {
  const TriangleOf<Polynomial> parent = any_triangle();
  Rational terms = 0;
  for (const TriangleOf<Polynomial>& child : children(parent, part))
    terms += differing_terms(
        4 * twice_area(child[0], child[1], child[2]) - twice_area(parent[0], parent[1], parent[2]), 0);
  return terms;
}

// m(1/2,1/2) less the middle of m(1,0) and m(0,1), for m = F(t, s) after `bent`: the largest coordinate.
Ball off_the_middle(const Chart& chart, bool bent) {
  const ChartIn<Ball>& formula = chart.in<Ball>();
  const auto at = [&](const Rational& s, const Rational& t) {
    return formula.frame({Ball(bent ? s * s : s), Ball(t)}).point;
  };
  const Rational half(1, 2);
  const Vector<Ball> off = at(half, half) - Ball(half) * (at(1, 0) + at(0, 1));
  return max(abs(off.x), max(abs(off.y), abs(off.z)));
}

}  // namespace

Finding equation_12(const Bench&) {
  const IsExactly none{0};
  Finding finding;
  for (const Surface& surface : {two_piece(2), sphere()}) {
    const std::string of = ", all triangles of level 2, " + surface.name;
    finding.require("points where the library's map is not (12)" + of, none,
                    points_apart(surface, 2, Numbering::of_m06));
    finding.control("points where it is not the map of (29) of ac98" + of, none,
                    points_apart(surface, 2, Numbering::of_ac98));
  }
  return finding;
}

Finding equation_12_one_to_one(const Bench&) {
  Finding finding;
  finding.require("terms of four times a child's determinant less its parent's, any triangle", IsExactly{0},
                  terms_of_quarters(Rational(1, 2)));
  finding.control("the same, sides divided at a third", IsExactly{0}, terms_of_quarters(Rational(1, 3)));
  const IsExactly one{1};
  for (const Domain& domain : domains(0))
    for (const Triangle& t : domain.triangles)
      finding.require("determinant of a coarse triangle, " + domain.name, one, twice_area(t[0], t[1], t[2]));
  const Triangle flat{{{0, 0}, {1, 1}, {3, 3}}};
  finding.control("determinant of a triangle with its vertices on a line", one,
                  twice_area(flat[0], flat[1], flat[2]));
  for (const Surface& surface : {two_piece(2), sphere()})
    finding.require("triangles of levels 1 to 4 that are not such children, " + surface.name, IsExactly{0},
                    differing_children(surface, 4));
  return finding;
}

Finding equation_12_affine(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith zero{.value = Ball(0), .within = 1e-25};
  const Surface curved = sphere();
  const Surface plane = octahedron();
  const Ball off = off_the_middle(curved.charts[0], false);
  Finding finding;
  finding.require("m_k(1/2,1/2) less the middle of m_k(1,0) and m_k(0,1), an octant of the sphere", zero,
                  off);
  finding.instead("the same on a face of the octahedron, where F is affine", zero,
                  off_the_middle(plane.charts[0], false));
  finding.control("the same on that face after (s,t) -> (s^2,t)", zero,
                  off_the_middle(plane.charts[0], true));
  finding.show(proved(off));
  return finding;
}

}  // namespace radcert::verification::m06
