// SPDX-License-Identifier: GPL-3.0-or-later

// What symmetric refinement does to lengths and shapes: (11), (32)-(33) and the partition in the proof of
// Theorem 7. Each child is its parent halved, one of the four turned by a half turn as well: an identity in
// the six coordinates of a triangle. By induction it holds at all levels that h is halved each time, and that
// each r(tau) is that of a coarse triangle.
//
// (33) keeps the angles from 0: let a, b, c be the sides, s half their sum, theta the angle that faces a. The
// circle touches b and c at the distance s - a from their corner, so that h* = (s - a) tan(theta/2), and s -
// a is at most the longest side: tan(theta/2) >= 1/r(tau).
//
// Theorem 7: refined L times, a triangle is the image of the lattice with the N = 2^L upright triangles a
// side, (i,j), (i+1,j), (i,j+1) with i + j < N, and the turned ones, (i+1,j+1), (i,j+1), (i+1,j) with i + j <
// N - 1: refinement takes those of N to those of 2N. Each turned triangle is the half turn of the upright one
// across each of its sides. Pairing along the sides of one direction leaves N(N+1)/2 - N(N-1)/2 = N upright
// triangles, those at one side.
//
// Checked      these identities, for all triangles, i, j and N; that the library's levels 1 to 4 are such
//              children; h, r(tau) and the number of triangles without a partner at the levels 0 to 4, by
//              measuring them. Rejected: sides divided at a third, a graded triangulation, a thin triangle, a
//              triangle left out, a neighbour that is no half turn.
// Not checked  other refinements. (33) has curved triangles for the plane ones of (32), and the "radius of
//              the circle" makes r(tau) = 2 sqrt 3 for the equilateral triangle.

#include <algorithm>
#include <map>
#include <vector>

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/m06/section_2/symmetric_refinement.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Side = std::array<Corner, 2>;

constexpr int levels = 5;
const Rational third(1, 3);

std::array<Side, 3> sides(const Triangle& t) {
  return {Side{t[0], t[1]}, Side{t[1], t[2]}, Side{t[2], t[0]}};
}

Rational squared(const Side& side) {
  const Rational dx = side[1][0] - side[0][0];
  const Rational dy = side[1][1] - side[0][1];
  return dx * dx + dy * dy;
}

Rational squared_mesh_size(const std::vector<Triangle>& triangles) {
  Rational largest = 0;
  for (const Triangle& t : triangles)
    for (const Side& side : sides(t)) largest = std::max(largest, squared(side));
  return largest;
}

// The step of the induction, and that the library takes it.
void require_halved(Finding& finding) {
  const IsExactly none{0};
  finding.require("terms of the children's sides less half of their parent's, any triangle", none,
                  terms_of_halved_sides());
  finding.control("the same, sides divided at a third", none, terms_of_halved_sides(third));
  for (const Surface& surface : {two_piece(2), sphere()})
    finding.require("triangles of levels 1 to 4 that are not such children, " + surface.name, none,
                    differing_children(surface, 4));
}

// h(tau)/h*(tau): the longest side times half the perimeter over the area.
Ball ratio(const Triangle& t) {
  Ball longest = 0;
  Ball perimeter = 0;
  for (const Side& side : sides(t)) {
    const Ball length = sqrt(Ball(squared(side)));
    longest = max(longest, length);
    perimeter += length;
  }
  return longest * perimeter / Ball(abs(twice_area(t[0], t[1], t[2])));
}

Ball largest_ratio(const Domain& domain) {
  Ball largest = 0;
  for (const Triangle& t : domain.triangles) largest = max(largest, ratio(t));
  return largest;
}

// Heron: 4 (twice the area)^2 = (a+b+c)(b+c-a)(c+a-b)(a+b-c), the right side in the squares of the sides.
Rational terms_of_heron() {
  const TriangleOf<Polynomial> v = any_triangle();
  const auto square = [](const CornerOf<Polynomial>& p, const CornerOf<Polynomial>& q) {
    const Polynomial dx = q[0] - p[0];
    const Polynomial dy = q[1] - p[1];
    return dx * dx + dy * dy;
  };
  const Polynomial a = square(v[1], v[2]);
  const Polynomial b = square(v[2], v[0]);
  const Polynomial c = square(v[0], v[1]);
  const Polynomial area = twice_area(v[0], v[1], v[2]);
  return differing_terms(4 * area * area - (2 * a * b + 2 * b * c + 2 * c * a - a * a - b * b - c * c), 0);
}

// With 16 A^2 = (a+b+c)(b+c-a)(c+a-b)(a+b-c), h* = A/s and cos theta = (b^2+c^2-a^2)/(2bc): h*^2 (1 + cos
// theta) = (s - apart)^2 (1 - cos theta), which is h* = (s - apart) tan(theta/2), times 32 s^2 b c.
Rational terms_of_tangent(const Polynomial& twice_apart) {
  const Polynomial a = Polynomial::variable("a");
  const Polynomial b = Polynomial::variable("b");
  const Polynomial c = Polynomial::variable("c");
  const Polynomial twice_s = a + b + c;
  const Polynomial area = twice_s * (b + c - a) * (c + a - b) * (a + b - c);
  const Polynomial tangent = twice_s - twice_apart;
  const Polynomial cosine = b * b + c * c - a * a;
  return differing_terms(
      area * (2 * b * c + cosine) - twice_s * twice_s * tangent * tangent * (2 * b * c - cosine), 0);
}

// 2 (c - (s - a)) = c + a - b, which is not negative.
Rational terms_of_longest() {
  const Polynomial a = Polynomial::variable("a");
  const Polynomial b = Polynomial::variable("b");
  const Polynomial c = Polynomial::variable("c");
  return differing_terms(2 * c - (b + c - a) - (c + a - b), 0);
}

const Polynomial& lattice_i() {
  static const Polynomial i = Polynomial::variable("i");
  return i;
}
const Polynomial& lattice_j() {
  static const Polynomial j = Polynomial::variable("j");
  return j;
}

TriangleOf<Polynomial> upright(const Polynomial& i, const Polynomial& j) {
  return {{{i, j}, {i + 1, j}, {i, j + 1}}};
}
TriangleOf<Polynomial> turned(const Polynomial& i, const Polynomial& j) {
  return {{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}};
}

Rational terms_apart(const TriangleOf<Polynomial>& a, const TriangleOf<Polynomial>& b) {
  Rational terms = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 2; ++c) terms += differing_terms(a[k][c], b[k][c]);
  return terms;
}

// The children of the upright and of the turned triangle at (i,j), lengths doubled, against those of the
// lattice.
Rational terms_of_lattice(const Rational& part) {
  const Polynomial i = 2 * lattice_i();
  const Polynomial j = 2 * lattice_j();
  const auto doubled = [](TriangleOf<Polynomial> t) {
    for (CornerOf<Polynomial>& corner : t)
      for (Polynomial& coordinate : corner) coordinate = 2 * coordinate;
    return t;
  };
  const auto of_upright = children(doubled(upright(lattice_i(), lattice_j())), part);
  const auto of_turned = children(doubled(turned(lattice_i(), lattice_j())), part);
  return terms_apart(of_upright[0], upright(i, j)) + terms_apart(of_upright[1], upright(i + 1, j)) +
         terms_apart(of_upright[2], upright(i, j + 1)) + terms_apart(of_upright[3], turned(i, j)) +
         terms_apart(of_turned[0], turned(i + 1, j + 1)) + terms_apart(of_turned[1], turned(i, j + 1)) +
         terms_apart(of_turned[2], turned(i + 1, j)) + terms_apart(of_turned[3], upright(i + 1, j + 1));
}

// The turned triangle at (i,j) less the half turn of the upright one at (i + di, j + dj) about ((2i + 1 +
// di)/2, (2j + 1 + dj)/2).
Rational terms_of_half_turn(int di, int dj) {
  TriangleOf<Polynomial> image = upright(lattice_i() + di, lattice_j() + dj);
  const std::array<Polynomial, 2> sum{2 * lattice_i() + 1 + di, 2 * lattice_j() + 1 + dj};
  for (CornerOf<Polynomial>& corner : image)
    for (std::size_t c = 0; c < 2; ++c) corner[c] = sum[c] - corner[c];
  return terms_apart(image, turned(lattice_i(), lattice_j()));
}

// How many vertices the two have in common: with two the half turn, which takes vertices to vertices, is that
// of a parallelogram about the middle of its diagonal.
Rational common_vertices(int di, int dj) {
  long count = 0;
  for (const CornerOf<Polynomial>& a : turned(lattice_i(), lattice_j()))
    for (const CornerOf<Polynomial>& b : upright(lattice_i() + di, lattice_j() + dj))
      if (differing_terms(a[0], b[0]) == 0 && differing_terms(a[1], b[1]) == 0) ++count;
  return {count};
}

Rational terms_of_count(int turned_fewer) {
  const Polynomial n = Polynomial::variable("n");
  const Polynomial half = Rational(1, 2);
  return differing_terms(half * n * (n + 1) - half * n * (n - turned_fewer) - n, 0);
}

// Of the triangles inside a coarse one, those that are left when pairs with a common side of one direction
// are taken out.
Rational unpaired(const std::vector<Triangle>& inside, const Side& parallel) {
  std::map<Side, long> common;
  for (const Triangle& t : inside)
    for (Side side : sides(t)) {
      const Rational turn = (side[1][0] - side[0][0]) * (parallel[1][1] - parallel[0][1]) -
                            (side[1][1] - side[0][1]) * (parallel[1][0] - parallel[0][0]);
      if (turn != 0) continue;
      std::sort(side.begin(), side.end());
      ++common[side];
    }
  return {static_cast<long>(
      std::count_if(common.begin(), common.end(), [](const auto& each) { return each.second == 1; }))};
}

}  // namespace

Finding equation_11(const Bench&) {
  Finding finding;
  require_halved(finding);
  const AgreesWith rounding{.value = Ball(0), .within = 0x1p-50};
  TriangulationOptions graded;
  graded.grading = 2;
  for (const Surface& surface : {two_piece(2), sphere()})
    for (int level = 0; level < levels; ++level) {
      const std::string of = ", " + surface.name + ", level " + std::to_string(level);
      const Rational square = squared_mesh_size(triangles_of(surface, level, 0));
      finding.require("h^2" + of, IsExactly{2 / power(Rational(4), level)}, square);
      finding.require("mesh_size - h" + of, rounding,
                      Ball(mesh_size(triangulate(surface, level))) - sqrt(Ball(square)));
      if (level > 1 && surface.charts[0].facts().domain == ChartDomain::unit_square) {
        finding.control("h^2" + of + ", graded towards the sides", IsExactly{2 / power(Rational(4), level)},
                        squared_mesh_size(triangles_of(surface, level, 0, graded)));
        finding.control("mesh_size of the graded one - h" + of, rounding,
                        Ball(mesh_size(triangulate(surface, level, graded))) - sqrt(Ball(square)));
      }
    }
  return finding;
}

Finding equation_33(const Bench&) {
  const BallPrecision precision(128);
  Finding finding;
  require_halved(finding);
  const AgreesWith coarse{.value = Ball(2) * sqrt(Ball(2)) * (Ball(1) + sqrt(Ball(2)) / Ball(2)),
                          .within = 1e-30};
  for (int level = 0; level < levels; ++level)
    for (const Domain& domain : domains(level))
      finding.require("largest r(tau)" + named(domain, level), coarse, largest_ratio(domain));
  const Polynomial a = Polynomial::variable("a");
  const Polynomial b = Polynomial::variable("b");
  const IsExactly none{0};
  finding.require("terms of Heron's formula, any triangle", none, terms_of_heron());
  finding.require("terms of h* = (s - a) tan(theta/2), a the side that faces theta", none,
                  terms_of_tangent(2 * a));
  finding.control("terms of h* = (s - b) tan(theta/2), a the side that faces theta", none,
                  terms_of_tangent(2 * b));
  finding.require("terms of 2 (c - (s - a)) = c + a - b", none, terms_of_longest());
  for (const int k : {1, 10, 20}) {
    const Rational thin = 1 / power(Rational(2), k);
    const Triangle flat{{{0, 0}, {1, 0}, {0, thin}}};
    finding.control("r(tau), a triangle with an angle near 2^-" + std::to_string(k), coarse, ratio(flat));
  }
  return finding;
}

Finding theorem_7_partition(const Bench&) {
  const IsExactly none{0};
  Finding finding;
  finding.require("terms of the children of a lattice triangle less those of the finer lattice", none,
                  terms_of_lattice(Rational(1, 2)));
  finding.control("the same, sides divided at a third", none, terms_of_lattice(third));
  const IsExactly two{2};
  for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {0, 1}}) {
    const std::string of = " (i + " + std::to_string(di) + ", j + " + std::to_string(dj) + ")";
    finding.require("terms of a turned triangle at (i,j) less the half turn of the upright one at" + of, none,
                    terms_of_half_turn(di, dj));
    finding.require("common vertices of a turned triangle at (i,j) and the upright one at" + of, two,
                    common_vertices(di, dj));
  }
  finding.control("common vertices of a turned triangle at (i,j) and the upright one at (i - 1, j + 1)", two,
                  common_vertices(-1, 1));
  finding.require("terms of N(N+1)/2 - N(N-1)/2 - N", none, terms_of_count(1));
  finding.control("terms of N(N+1)/2 - N(N-2)/2 - N", none, terms_of_count(2));
  finding.require("triangles of levels 1 to 4 that are not such children, sphere", none,
                  differing_children(sphere(), 4));
  for (int level = 0; level < levels; ++level) {
    const Domain domain = domains(level).back();
    const IsExactly rest{power(Rational(2), level)};
    for (std::size_t i = 0; i < 3; ++i)
      finding.require("triangles in no parallelogram, sides parallel to side " + std::to_string(i + 1) +
                          named(domain, level),
                      rest, unpaired(domain.triangles, {domain.corners[i], domain.corners[(i + 1) % 3]}));
    if (level == 0) continue;
    std::vector<Triangle> fewer = domain.triangles;
    fewer.erase(fewer.begin());
    finding.control("triangles in no parallelogram, one triangle left out" + named(domain, level), rest,
                    unpaired(fewer, {domain.corners[0], domain.corners[1]}));
  }
  return finding;
}

}  // namespace radcert::verification::m06
