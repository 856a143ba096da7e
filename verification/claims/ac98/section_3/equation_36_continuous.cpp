// SPDX-License-Identifier: GPL-3.0-or-later

// For alpha = 0 the nodes are the vertices, and l_i is 0 on the side opposite to its vertex: on a side P_n g
// is the linear function, in the parameter along it, of the values of g at its two ends. Two elements with a
// common side have the same ends there, and the same P_n g if and only if they give the same points the same
// parameter: the charts must parametrise their seams affinely in each other, which is not printed. Then P_n g
// is continuous for every g, and P_n a projection on C(S).
//
// Checked      l_i on the opposite side, by the library's basis, exactly. On surfaces of the catalogue whose
//              charts meet: each side of level 1 that two elements have in common, found by its ends, has the
//              same middle and the same first quarter from both. Rejected: a side that is t in one chart and
//              t^2 in the other, on which the interpolants of g = t differ.
// Not checked  other surfaces; sides of finer levels, but by the affine charts of the seams.

#include <array>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Values of the basis of degree 1 with this alpha that are not 0 on the side opposite to their vertex.
Rational values_on_opposite_sides(const Rational& alpha) {
  const InsetBasis<Rational> basis(1, alpha);
  const std::vector<Barycentric<Rational>> nodes = basis.nodes();
  long count = 0;
  for (std::size_t side = 0; side < 3; ++side)
    for (const Rational& part : {Rational(0), Rational(1, 3), Rational(1)}) {
      Barycentric<Rational> at;
      at.x.at(side) = 0;
      at.x.at((side + 1) % 3) = part;
      at.x.at((side + 2) % 3) = 1 - part;
      std::array<Rational, 3> values;
      basis.values(at, std::span<Rational>(values));
      for (std::size_t j = 0; j < 3; ++j)
        if (nodes.at(j).x.at(side) > nodes.at(j).x.at((side + 1) % 3) && values.at(j) != 0) ++count;
    }
  return {count};
}

// A side of an element in space: its ends, its middle, its first quarter and its last.
struct Side {
  std::size_t chart;
  std::array<Vector<Ball>, 5> points;
};

std::vector<Side> sides_of(const Surface& surface) {
  std::vector<Side> sides;
  for (const ParameterTriangle& t : triangulate(surface, 1).triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      Side side{.chart = t.chart, .points = {}};
      const ParameterPoint<double>& from = t.vertices.at(i);
      const ParameterPoint<double>& to = t.vertices.at((i + 1) % 3);
      constexpr std::array<double, 5> parts{0, 1, 0.5, 0.25, 0.75};
      for (std::size_t k = 0; k < 5; ++k) {
        // The parameters are multiples of 1/8 at most, so that these are exact.
        const ParameterPoint<double> at = from + parts.at(k) * (to - from);
        side.points.at(k) = surface.charts.at(t.chart).in<Ball>().frame({Ball(at.s), Ball(at.t)}).point;
      }
      sides.push_back(side);
    }
  return sides;
}

bool the_same(const Vector<Ball>& a, const Vector<Ball>& b) {
  return overlaps(a.x, b.x) && overlaps(a.y, b.y) && overlaps(a.z, b.z);
}

// The sum of the coordinates' distances.
Ball apart(const Vector<Ball>& a, const Vector<Ball>& b) {
  return abs(a.x - b.x) + abs(a.y - b.y) + abs(a.z - b.z);
}

// Sides of two charts with common ends.
struct Seams {
  Ball furthest{-1};  ///< the largest distance of their middles and of their first quarters
  long pairs = 0;
};

Seams seams_of(const Surface& surface) {
  const std::vector<Side> sides = sides_of(surface);
  Seams seams;
  for (const Side& a : sides)
    for (const Side& b : sides) {
      if (a.chart >= b.chart) continue;
      const bool along = the_same(a.points[0], b.points[0]) && the_same(a.points[1], b.points[1]);
      const bool against = the_same(a.points[0], b.points[1]) && the_same(a.points[1], b.points[0]);
      if (!along && !against) continue;
      // Where b runs the other way, its last quarter is the first one of a.
      const Vector<Ball>& quarter = b.points[along ? 3 : 4];
      seams.furthest = max(seams.furthest, max(apart(a.points[2], b.points[2]), apart(a.points[3], quarter)));
      ++seams.pairs;
    }
  return seams;
}

}  // namespace

Finding equation_36_continuous_alpha_0(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  finding.require("values of l_i on the side opposite to their vertex that are not 0, alpha = 0",
                  IsExactly{0}, values_on_opposite_sides(0));
  finding.control("the same, alpha = 1/6", IsExactly{0}, values_on_opposite_sides(Rational(1, 6)));
  const AgreesWith together{.value = Ball(0), .within = 1e-40};
  // Each of the twelve edges, of the one edge, is two sides at level 1, with common ends only where both
  // charts halve it at one point.
  struct Case {
    std::string name;
    Surface surface;
    long pairs;
  };
  for (const auto& [name, surface, pairs] : {Case{"sphere", sphere(), 24},
                                             {"ellipsoid (1,2,5)", ellipsoid(1, 2, 5), 24},
                                             {"cube", cube(), 24},
                                             {"two_squares", two_squares(), 2}}) {
    const Seams seams = seams_of(surface);
    finding.require("pairs of sides of two charts with common ends, " + name, IsExactly{pairs},
                    Rational(seams.pairs));
    finding.require("largest distance of a middle or quarter of a side from two charts, " + name, together,
                    seams.furthest);
  }
  Surface open = cube();
  open.charts.pop_back();
  open.diagonals.pop_back();
  finding.control("pairs of sides of two charts with common ends, the cube without a wall", IsExactly{24},
                  Rational(seams_of(open).pairs));
  // The first chart's parameter is t, the second's t^2 at the same point: at t = 1/4 the interpolants of g =
  // t.
  const Ball quarter(Rational(1, 4));
  finding.control("difference of the two interpolants of g = t, t in one chart and t^2 in the other",
                  together, sqrt(quarter) - quarter);
  return finding;
}

}  // namespace radcert::verification::ac98
