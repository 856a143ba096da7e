// SPDX-License-Identifier: GPL-3.0-or-later

// m_k is the chart after the affine map of sigma onto the parameter triangle. The affine map has an inverse,
// by determinants, where the triangle has an area. So m_k is one-to-one if the chart is, and onto Delta_k by
// definition.
//
// Checked      the inverse of the affine map, as an identity of rational functions of the corners, s and t.
//              The charts of the catalogue that the papers use: on two_piece x and y are the parameters; on
//              octants of ellipsoids (y/b, z/c)/(x/a + y/b + z/c) gives them back, as F = D e/|e| with e =
//              (1-s-t, s, t); by the library's charts at points. A triangle whose corners are on a line, and
//              another chart's inverse, are rejected.
// Not checked  charts of other surfaces.

#include <array>

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/surface.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/planar_rule.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// v_1, v_2, v_3, and (s, t).
using Eight = std::array<Rational, 8>;

Rational determinant(const PlanarPoint& a, const PlanarPoint& b) { return a.x * b.y - a.y * b.x; }

// The coordinate s of the point u v_3 + t v_2 + s v_1, by determinants, times that of the triangle.
Rational recovered(const Eight& x) {
  const PlanarPoint first{x[0] - x[4], x[1] - x[5]};
  const PlanarPoint second{x[2] - x[4], x[3] - x[5]};
  const PlanarPoint p{x[7] * second.x + x[6] * first.x, x[7] * second.y + x[6] * first.y};
  return determinant(p, second);
}

Rational scaled(const Eight& x, bool on_a_line) {
  const PlanarPoint first{x[0] - x[4], x[1] - x[5]};
  const PlanarPoint second =
      on_a_line ? PlanarPoint{2 * first.x, 2 * first.y} : PlanarPoint{x[2] - x[4], x[3] - x[5]};
  return x[6] * determinant(first, second);
}

Rational differing_inverses(bool on_a_line) {
  constexpr long values = 3;
  return differing_on_grid<8>(values, recovered, [&](const Eight& x) { return scaled(x, on_a_line); });
}

// The parameters from a point of the surface.
using Inverse = std::array<Ball, 2> (*)(const Vector<Ball>&);

// The largest distance of the parameters from what is made of the point, over a few parameters of a chart.
Ball furthest(const Chart& chart, const Inverse& inverse) {
  Ball largest(0);
  for (const auto& [s, t] : {std::array<Rational, 2>{Rational(1, 3), Rational(1, 5)},
                             {Rational(1, 7), Rational(3, 4)},
                             {0, Rational(1, 2)},
                             {Rational(1, 2), 0}}) {
    const std::array<Ball, 2> found = inverse(chart.in<Ball>().frame({Ball(s), Ball(t)}).point);
    largest = max(largest, abs(found[0] - Ball(s)) + abs(found[1] - Ball(t)));
  }
  return largest;
}

std::array<Ball, 2> first_two(const Vector<Ball>& p) { return {p.x, p.y}; }

// Of the first octant of the ellipsoid (1,2,5).
std::array<Ball, 2> of_octant(const Vector<Ball>& p) {
  const Vector<Ball> e{p.x, p.y / Ball(2), p.z / Ball(5)};
  const Ball sum = e.x + e.y + e.z;
  return {e.y / sum, e.z / sum};
}

}  // namespace

Finding equation_29_bijective(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  finding.require("corners and points whose s is not given back by determinants", IsExactly{0},
                  differing_inverses(false));
  finding.control("the same with three corners on a line", IsExactly{0}, differing_inverses(true));
  const AgreesWith given_back{.value = Ball(0), .within = 1e-50};
  for (const int p : {2, 3})
    for (const std::size_t chart : {std::size_t{0}, std::size_t{1}})
      finding.require(
          "parameters less (x, y), two_piece(" + std::to_string(p) + "), chart " + std::to_string(chart),
          given_back, furthest(two_piece(p).charts.at(chart), first_two));
  finding.require("parameters less (y/b, z/c)/(x/a + y/b + z/c), first octant of the ellipsoid (1,2,5)",
                  given_back, furthest(ellipsoid(1, 2, 5).charts.at(0), of_octant));
  finding.control("parameters of that octant less (x, y)", given_back,
                  furthest(ellipsoid(1, 2, 5).charts.at(0), first_two));
  return finding;
}

}  // namespace radcert::verification::ac98
