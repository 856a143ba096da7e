// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      equation_72_power: that the bounds (60) and (65) "must now contain a term proportional to some
//              power of r(tau)": the constants 21/20 and 19/2 of lemma_3_2.cpp and lemma_3_3.cpp contain
//              none, and the largest error over the rest of the bound does not grow with r, as the gradient
//              of f - L f does. r encloses h/h*, 2 area = h* times the perimeter. equation_73: the triangles of every level are similar to
//              those of level 0, by the squares of their sides, in exact arithmetic: the supremum is the
//              largest r of level 0. r tan(theta/2) >= 1 for the smallest angle theta, as tan(theta/2) =
//              h*/(s - a), s half the perimeter and a the side opposite, and s - a <= h. equation_79_pairs: n
//              grows by 4; a symmetric triangulation is paired through the sides of one direction, exactly;
//              what is left over on the octants of the sphere is 2^level triangles each, and nothing on unit
//              squares.
// Not checked  pairs in other polygons; that the triangles left over can be kept away from v_i on every chart
// at once.

#include <algorithm>
#include <map>
#include <set>

#include "radcert/scalar/real.h"
#include "radcert/surface/catalogue.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/collocation/interpolation_bounds.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
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
Approximation growth(const Ball& first, const Ball& last, long thin, long thinner) {
  return proved(log(last / first) /
                log(shape(thin_triangle(thinner)).ratio() / shape(thin_triangle(thin)).ratio()));
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

struct Pairing {
  long triangles = 0;
  long left_over = 0;
  long no_parallelogram = 0;  ///< pairs whose union is none
};

// Pairs the triangles of each chart across their sides of one direction: that of the side from vertex `from`
// to the next, of the chart's first triangle at level 0.
Pairing paired(const Surface& surface, int level, std::size_t from) {
  std::map<std::size_t, PlanarPoint> direction;
  for (const ParameterTriangle& t : triangulate(surface, 0).triangles) {
    const PlanarTriangle v = exact(t);
    const PlanarPoint& a = v.at(from);
    const PlanarPoint& b = v.at((from + 1) % 3);
    direction.insert({t.chart, {b.x - a.x, b.y - a.y}});
  }
  struct Half {
    PlanarPoint opposite;
    PlanarPoint sum;  ///< of the side's ends
  };
  std::map<std::pair<std::size_t, std::pair<Rational, Rational>>, std::vector<Half>> by_side;
  Pairing result;
  for (const ParameterTriangle& t : triangulate(surface, level).triangles) {
    ++result.triangles;
    const PlanarTriangle v = exact(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanarPoint& a = v.at(i);
      const PlanarPoint& b = v.at((i + 1) % 3);
      const PlanarPoint& along = direction.at(t.chart);
      if ((b.x - a.x) * along.y != (b.y - a.y) * along.x) continue;
      const PlanarPoint sum{a.x + b.x, a.y + b.y};
      by_side[{t.chart, {sum.x, sum.y}}].push_back({v.at((i + 2) % 3), sum});
    }
  }
  for (const auto& [side, sharing] : by_side) {
    if (sharing.size() == 1) ++result.left_over;
    if (sharing.size() == 2 && (sharing[0].opposite.x + sharing[1].opposite.x != sharing[0].sum.x ||
                                sharing[0].opposite.y + sharing[1].opposite.y != sharing[0].sum.y))
      ++result.no_parallelogram;
  }
  return result;
}

}  // namespace

Finding equation_72_power(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  const Bound grows{.order = 1, .slack = 0.9, .why = "any positive power from a tenth on is let pass"};
  constexpr long thick = 100;
  constexpr long thin = 100000000;
  for (const long thinness : {1L, thick, thin}) {
    const std::string at = ", height 1/" + std::to_string(2 * thinness) + " of the diameter";
    const PlanarTriangle t = thin_triangle(thinness);
    const std::vector<PlanarPoint> p = thin_parallelogram(thinness);
    finding.require("products beyond (60) with c = 21/20" + at, IsExactly{0},
                    exceeding(bounded_errors({t}, {t.begin(), t.end()}, 1), Rational(21, 20)));
    finding.require(
        "products beyond (65) with c = 19/2" + at, IsExactly{0},
        exceeding(bounded_errors({{p[0], p[1], p[3]}, {p[1], p[2], p[3]}}, p, 2), Rational(19, 2)));
    finding.remark("r(tau)" + at, proved(shape(t).ratio()));
  }
  const Approximation exponent =
      growth(largest_on_a_triangle(thick), largest_on_a_triangle(thin), thick, thin);
  finding.require("exponent of r in the largest error over the rest of (60)", grows, exponent);
  finding.require("exponent of r in the largest error over the rest of (65)", grows,
                  growth(largest_on_a_parallelogram(thick), largest_on_a_parallelogram(thin), thick, thin));
  // With a derivative of the error on the left a power of r is needed, which may be what was meant.
  finding.instead("exponent of r in the derivative of f - L f by y over h |D^2 f|, f = x^2", grows,
                  growth(slope_across(thick), slope_across(thin), thick, thin));
  finding.control("exponent of r in max |L f|/max |f|, f = x^2 + y^2", grows,
                  growth(norm_seen(thick), norm_seen(thin), thick, thin));
  finding.show(exponent);
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
        finding.control("ellipsoid: triangles left over, over a number that does not grow with n" + through,
                        IsExactly{1}, Rational(octants.left_over, 8));
    }
    long fewest = paired(squares, level, 0).left_over;
    for (const std::size_t from : {1U, 2U}) fewest = std::min(fewest, paired(squares, level, from).left_over);
    finding.require("two_piece: triangles left over when paired through the diagonals" + at, IsExactly{0},
                    Rational(fewest));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
