// SPDX-License-Identifier: GPL-3.0-or-later

// equation_72_power: the bounds (60) and (65) "must now contain a term proportional to some power of r(tau)".
// They hold on every triangle with c = 21/10 and on every parallelogram with c = 20/3, and h the diameter:
// the steps of lemma_3_2.cpp and lemma_3_3.cpp know no shape.
//
// equation_73: symmetric refinement cuts a triangle into four whose sides are half of its own, three alike
// and one turned by a half turn, so that by induction all triangles of all levels have the r of level 0. r
// tan(theta/2) >= 1 for the smallest angle theta, as tan(theta/2) = h*/(s - a), s half the perimeter and a
// the side opposite, and s - a = (b + c - a)/2 <= c <= h, as b - a <= c.
//
// equation_79_pairs: n grows by 4. Of U triangles alike to one of level 0 and V turned ones the next level
// has 3U + V and U + 3V, so that U - V doubles. A turned one lies inside that triangle and shares its side
// of a given direction with an alike one, each with another. So U - V triangles are left over: 2^level for
// each of level 0.
//
// Checked      equation_72_power: the constants, and that the largest error over the rest of the bound does
//              not grow with r for products of monomials, as it does with h* for h, and as the gradient of f
//              - L f does. r encloses h/h*, 2 area = h* times the perimeter. equation_73: the four children
//              as identities in the coordinates of the corners; the library's triangles of levels up to 6.
//              The tangent's inequality on triangles. equation_79_pairs: the matrix of (U,V); the library's
//              triangulations, paired exactly: 2^level triangles left over on each octant of the ellipsoid,
//              and nothing on unit squares.
// Not checked  tan(theta/2) = h*/(s - a) itself.

#include <algorithm>
#include <map>
#include <set>

#include "radcert/scalar/real.h"
#include "radcert/surface/catalogue.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/collocation/interpolation_bounds.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

Rational square_of_distance(const PlanarPoint& a, const PlanarPoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// The squares of the sides, ascending.
std::array<Rational, 3> squared_sides(const PlanarTriangle& v) {
  std::array<Rational, 3> sides{square_of_distance(v[0], v[1]), square_of_distance(v[1], v[2]),
                                square_of_distance(v[2], v[0])};
  std::sort(sides.begin(), sides.end());
  return sides;
}

Ball twice_the_area(const PlanarTriangle& v) {
  return Ball(abs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y)));
}

struct Shape {
  Ball diameter;
  Ball inscribed;  ///< radius
  Ball half_perimeter;
  Ball shortest;
  [[nodiscard]] Ball ratio() const { return diameter / inscribed; }
  [[nodiscard]] Ball tangent_of_half_the_smallest_angle() const {
    return inscribed / (half_perimeter - shortest);
  }
};

Shape shape(const PlanarTriangle& v) {
  const std::array<Rational, 3> squares = squared_sides(v);
  const Ball a = sqrt(Ball(squares[0]));
  const Ball b = sqrt(Ball(squares[1]));
  const Ball c = sqrt(Ball(squares[2]));
  return {c, twice_the_area(v) / (a + b + c), (a + b + c) / Ball(2), a};
}

Ball circumradius(const PlanarTriangle& v) {
  const std::array<Rational, 3> squares = squared_sides(v);
  return sqrt(Ball(squares[0] * squares[1] * squares[2])) / (Ball(2) * twice_the_area(v));
}

PlanarTriangle thin_triangle(long thinness) {
  return {PlanarPoint{0, 0}, PlanarPoint{1, 0}, PlanarPoint{Rational(1, 3), Rational(1, 2 * thinness)}};
}

// The parallelogram of that triangle and its image.
std::vector<PlanarPoint> thin_parallelogram(long thinness) {
  const PlanarPoint tip = thin_triangle(thinness)[2];
  return {{0, 0}, {1, 0}, {tip.x + 1, tip.y}, tip};
}

// The exponent with which `last` exceeds `first` as r grows.
Ball growth(const Ball& first, const Ball& last, long thin, long thinner) {
  return log(last / first) / log(shape(thin_triangle(thinner)).ratio() / shape(thin_triangle(thin)).ratio());
}

Ball largest_on_a_triangle(long thinness) {
  const PlanarTriangle t = thin_triangle(thinness);
  return Ball(largest_ratio(bounded_errors({t}, {t.begin(), t.end()}, 1)));
}

Ball largest_on_a_parallelogram(long thinness) {
  const std::vector<PlanarPoint> p = thin_parallelogram(thinness);
  return Ball(largest_ratio(bounded_errors({{p[0], p[1], p[3]}, {p[1], p[2], p[3]}}, p, 2)));
}

// What does grow with r: the derivative by y of L f for f = x^2, whose own is 0; h and |D^2 f| are fixed.
Ball slope_across(long thinness) {
  const ExactPolynomial across =
      interpolant(thin_triangle(thinness), Rational(1, 6), ExactPolynomial::monomial(2, 0)).by_y();
  return Ball(abs(across({0, 0})));
}

// max |L f|/max |f| for f = x^2 + y^2: both are largest at a vertex, one being linear, the other convex.
Ball norm_seen(long thinness) {
  const PlanarTriangle t = thin_triangle(thinness);
  const ExactPolynomial f = ExactPolynomial::monomial(2, 0) + ExactPolynomial::monomial(0, 2);
  const std::vector<PlanarPoint> vertices{t.begin(), t.end()};
  return Ball(largest_at(vertices, {interpolant(t, Rational(1, 6), f)}) / largest_at(vertices, {f}));
}

// A triangle of the next level in the coordinates of the corners v_1, v_2, v_3 of its parent, and whether its
// edges are along those of the parent or against them.
using Weights = std::array<Rational, 3>;

struct Child {
  std::array<Weights, 3> corners;
  int sign;
};

// The four triangles that the points at `part` of each side make.
std::array<Child, 4> children(const Rational& part) {
  const std::array<Weights, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto between = [&](std::size_t i, std::size_t j) {
    Weights w;
    for (std::size_t k = 0; k < 3; ++k) w.at(k) = (1 - part) * v.at(i).at(k) + part * v.at(j).at(k);
    return w;
  };
  const Weights a = between(0, 1);
  const Weights b = between(1, 2);
  const Weights c = between(2, 0);
  return {{{{{v[0], a, c}}, 1}, {{{a, v[1], b}}, 1}, {{{c, b, v[2]}}, 1}, {{{b, c, a}}, -1}}};
}

// Coefficients of their edges that are not those of plus or minus half the parent's edge.
Rational edges_not_halved(const Rational& part) {
  const std::array<Weights, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  long count = 0;
  for (const Child& child : children(part))
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational edge = child.corners.at((i + 1) % 3).at(k) - child.corners.at(i).at(k);
        const Rational parent = v.at((i + 1) % 3).at(k) - v.at(i).at(k);
        if (edge != Rational(child.sign, 2) * parent) ++count;
      }
  return {count};
}

Surface named_surface(const std::string& name, const std::vector<Rational>& parameters) {
  return find_surface(name)->make(parameters);
}

PlanarTriangle exact(const ParameterTriangle& triangle) {
  PlanarTriangle result;
  for (std::size_t i = 0; i < 3; ++i)
    result.at(i) = {Rational::exactly(triangle.vertices.at(i).s),
                    Rational::exactly(triangle.vertices.at(i).t)};
  return result;
}

// Triangles of a level that are not similar, in the ratio 2^-level, to one of level 0 of their chart.
Rational triangles_out_of_shape(const Surface& surface, int level, double grading) {
  const TriangulationOptions options{.diagonals = std::nullopt, .grading = grading};
  std::set<std::pair<std::size_t, std::array<Rational, 3>>> shapes;
  for (const ParameterTriangle& t : triangulate(surface, 0).triangles)
    shapes.insert({t.chart, squared_sides(exact(t))});
  long count = 0;
  for (const ParameterTriangle& t : triangulate(surface, level, options).triangles) {
    std::array<Rational, 3> sides = squared_sides(exact(t));
    for (Rational& side : sides) side *= power(Rational(4), level);
    if (!shapes.contains({t.chart, sides})) ++count;
  }
  return {count};
}

// How a count of (U,V), triangles alike to one of level 0 and turned ones, goes on, by the signs of the
// children: (U - V) and (U + V) of the next level over those of this one.
std::array<Rational, 2> growth_of_counts() {
  long alike = 0;
  long turned = 0;
  for (const Child& child : children(Rational(1, 2))) (child.sign > 0 ? alike : turned) += 1;
  // U' = alike U + turned V, V' = turned U + alike V.
  return {Rational(alike - turned), Rational(alike + turned)};
}

struct PlacedTriangle {
  std::size_t chart = 0;
  PlanarTriangle corners;
};

std::vector<PlacedTriangle> triangles(const Surface& surface, int level) {
  std::vector<PlacedTriangle> result;
  for (const ParameterTriangle& t : triangulate(surface, level).triangles)
    result.push_back({t.chart, exact(t)});
  return result;
}

// The same with each triangle divided at its centroid, where that lies below and left of the diagonal of its
// square: triangles that satisfy (73) and make no parallelograms.
std::vector<PlacedTriangle> divided(const std::vector<PlacedTriangle>& whole) {
  std::vector<PlacedTriangle> result;
  for (const PlacedTriangle& each : whole) {
    const PlanarTriangle& v = each.corners;
    const Rational s = std::min({v[0].x, v[1].x, v[2].x});
    const Rational t = std::min({v[0].y, v[1].y, v[2].y});
    if (std::none_of(v.begin(), v.end(), [&](const PlanarPoint& p) { return p.x == s && p.y == t; })) {
      result.push_back(each);
      continue;
    }
    const PlanarPoint centroid{(v[0].x + v[1].x + v[2].x) / 3, (v[0].y + v[1].y + v[2].y) / 3};
    result.push_back({each.chart, {v[0], v[1], centroid}});
    result.push_back({each.chart, {centroid, v[1], v[2]}});
    result.push_back({each.chart, {v[0], centroid, v[2]}});
  }
  return result;
}

struct Pairing {
  long triangles = 0;
  long left_over = 0;         ///< in no pair whose union is a parallelogram
  long no_parallelogram = 0;  ///< pairs whose union is none
};

// Pairs the triangles of each chart across their sides of one direction: that of the side from vertex `from`
// to the next, of the chart's first triangle at level 0.
Pairing paired(const Surface& surface, const std::vector<PlacedTriangle>& all, std::size_t from) {
  std::map<std::size_t, PlanarPoint> direction;
  for (const PlacedTriangle& t : triangles(surface, 0)) {
    const PlanarPoint& a = t.corners.at(from);
    const PlanarPoint& b = t.corners.at((from + 1) % 3);
    direction.insert({t.chart, {b.x - a.x, b.y - a.y}});
  }
  struct Half {
    PlanarPoint opposite;
    PlanarPoint sum;  ///< of the side's ends
  };
  std::map<std::pair<std::size_t, std::pair<Rational, Rational>>, std::vector<Half>> by_side;
  for (const PlacedTriangle& t : all)
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanarPoint& a = t.corners.at(i);
      const PlanarPoint& b = t.corners.at((i + 1) % 3);
      const PlanarPoint& along = direction.at(t.chart);
      if ((b.x - a.x) * along.y != (b.y - a.y) * along.x) continue;
      const PlanarPoint sum{a.x + b.x, a.y + b.y};
      by_side[{t.chart, {sum.x, sum.y}}].push_back({t.corners.at((i + 2) % 3), sum});
    }
  Pairing result{.triangles = static_cast<long>(all.size()), .left_over = static_cast<long>(all.size())};
  for (const auto& [side, sharing] : by_side) {
    if (sharing.size() != 2) continue;
    if (sharing[0].opposite.x + sharing[1].opposite.x == sharing[0].sum.x &&
        sharing[0].opposite.y + sharing[1].opposite.y == sharing[0].sum.y)
      result.left_over -= 2;
    else
      ++result.no_parallelogram;
  }
  return result;
}

Pairing paired(const Surface& surface, int level, std::size_t from) {
  return paired(surface, triangles(surface, level), from);
}

}  // namespace

Finding equation_72_power(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  const LiesIn grows{Rational(1, 10), 10};  // any positive power from a tenth on
  constexpr long thick = 100;
  constexpr long thin = 100000000;
  for (const long thinness : {1L, thick, thin}) {
    const std::string at = ", height 1/" + std::to_string(2 * thinness) + " of the diameter";
    const PlanarTriangle t = thin_triangle(thinness);
    const std::vector<PlanarPoint> p = thin_parallelogram(thinness);
    finding.require("products beyond (60) with c = 21/10" + at, IsExactly{0},
                    exceeding(bounded_errors({t}, {t.begin(), t.end()}, 1), Rational(21, 10)));
    finding.require(
        "products beyond (65) with c = 20/3" + at, IsExactly{0},
        exceeding(bounded_errors({{p[0], p[1], p[3]}, {p[1], p[2], p[3]}}, p, 2), Rational(20, 3)));
    finding.remark("r(tau)" + at, proved(shape(t).ratio()));
  }
  // The proof: constants for every shape.
  require_mean_values(finding, 1);
  require_lengths(finding);
  const LiesIn bounded{0, 7};
  finding.require("c of (60) on every triangle", bounded, constant_on_triangles());
  finding.require("c of (65) on every parallelogram", bounded, constant_on_parallelograms());
  const Ball exponent = growth(largest_on_a_triangle(thick), largest_on_a_triangle(thin), thick, thin);
  finding.require("exponent of r in the largest error over the rest of (60)", grows, exponent);
  finding.require("exponent of r in the largest error over the rest of (65)", grows,
                  growth(largest_on_a_parallelogram(thick), largest_on_a_parallelogram(thin), thick, thin));
  const auto with_inscribed = [](long thinness) {
    return largest_on_a_triangle(thinness) / power(shape(thin_triangle(thinness)).inscribed, 3);
  };
  finding.instead("the same with h* for h", grows,
                  growth(with_inscribed(thick), with_inscribed(thin), thick, thin));
  // With a derivative of the error on the left a power of r is needed, which may be what was meant.
  finding.instead("exponent of r in the derivative of f - L f by y over h |D^2 f|, f = x^2", grows,
                  growth(slope_across(thick), slope_across(thin), thick, thin));
  finding.control("exponent of r in max |L f|/max |f|, f = x^2 + y^2", grows,
                  growth(norm_seen(thick), norm_seen(thin), thick, thin));
  finding.show(proved(exponent));
  return finding;
}

Finding equation_73(const Bench& bench) {
  const BallPrecision precision(192);
  Finding finding;
  const int last = bench.budget == Budget::quick ? 4 : 6;
  const std::vector<std::pair<std::string, std::vector<Rational>>> surfaces{
      {"two_piece", {2}}, {"ellipsoid", {1, 2, 5}}, {"spherical_cap", {Rational(1, 4)}}};
  for (const auto& [name, parameters] : surfaces) {
    const Surface surface = named_surface(name, parameters);
    for (int level = 1; level <= last; ++level)
      finding.require(name + ", level " + std::to_string(level) + ": triangles not similar to one of level 0",
                      IsExactly{0}, triangles_out_of_shape(surface, level, 1));
    Ball largest(0);
    for (const ParameterTriangle& t : triangulate(surface, 0).triangles)
      largest = max(largest, shape(exact(t)).ratio());
    finding.require(name + ", level 0: largest r, against that of half a square",
                    AgreesWith{2 + 2 * sqrt(Ball(2)), 1e-40}, largest);
  }
  finding.require("edges of the four children, over those of their parent, that are not 1/2 or -1/2",
                  IsExactly{0}, edges_not_halved(Rational(1, 2)));
  finding.control("the same for children cut at a third of each side", IsExactly{0},
                  edges_not_halved(Rational(1, 3)));
  finding.control("two_piece, level 2, graded by 2: triangles not similar to one of level 0", IsExactly{0},
                  triangles_out_of_shape(named_surface("two_piece", {2}), 2, 2));
  const AtMost none{.value = 0, .slack = 0, .why = ""};
  for (const long thinness : {1L, 10L, 1000L, 1000000L}) {
    const Shape thin = shape(thin_triangle(thinness));
    const std::string at = ", height 1/" + std::to_string(2 * thinness);
    finding.require("1 - r tan(theta/2)" + at, none,
                    proved(Ball(1) - thin.ratio() * thin.tangent_of_half_the_smallest_angle()));
    // The circle around the triangle in place of the one inside: R = abc/(4 area).
    finding.control("1 - (h/R) tan(theta/2), R the radius of the circumcircle" + at, none,
                    proved(Ball(1) - thin.diameter / circumradius(thin_triangle(thinness)) *
                                         thin.tangent_of_half_the_smallest_angle()));
  }
  return finding;
}

Finding equation_79_pairs(const Bench& bench) {
  Finding finding;
  const int last = bench.budget == Budget::quick ? 4 : 6;
  const auto [difference, sum] = growth_of_counts();
  finding.require("triangles of a level over those of the level before", IsExactly{4}, sum);
  finding.require("alike triangles less turned ones, over those of the level before", IsExactly{2},
                  difference);
  finding.require("edges of the four children, over those of their parent, that are not 1/2 or -1/2",
                  IsExactly{0}, edges_not_halved(Rational(1, 2)));
  const Surface ellipsoid = named_surface("ellipsoid", {1, 2, 5});
  const Surface squares = named_surface("two_piece", {2});
  for (int level = 0; level <= last; ++level) {
    const std::string at = ", level " + std::to_string(level);
    const long side = 1L << level;
    for (std::size_t from = 0; from < 3; ++from) {
      const Pairing octants = paired(ellipsoid, level, from);
      const std::string through = at + ", pairs through side " + std::to_string(from + 1);
      if (from == 0)
        finding.require("ellipsoid: n" + at, IsExactly{Rational(8 * side * side)},
                        Rational(octants.triangles));
      finding.require("ellipsoid: pairs that are no parallelogram" + through, IsExactly{0},
                      Rational(octants.no_parallelogram));
      finding.require("ellipsoid: triangles left over, over n^(1/2) 8^(1/2)" + through, IsExactly{1},
                      Rational(octants.left_over, 8 * side));
      if (level == last)
        finding.control(
            "ellipsoid, each upright triangle divided: left over, over n^(1/2) 8^(1/2)" + through,
            IsExactly{1},
            Rational(paired(ellipsoid, divided(triangles(ellipsoid, level)), from).left_over, 8 * side));
    }
    long fewest = paired(squares, level, 0).left_over;
    for (const std::size_t from : {1U, 2U}) fewest = std::min(fewest, paired(squares, level, from).left_over);
    finding.require("two_piece: triangles left over when paired through the diagonals" + at, IsExactly{0},
                    Rational(fewest));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
