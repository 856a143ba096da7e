// SPDX-License-Identifier: GPL-3.0-or-later

// Int |v_i - Q|^-2 over S without the element of v_i, alpha = 1/6. The node keeps a sixth of the least
// height of its element from the sides: h/12 for the right triangles of a unit square, h their longest
// side, and 3^(1/2) h/12 for the triangles of the plane x + y + z = 1 that x/|x| takes to the octants of
// the unit sphere, h their side there. Unit sphere: between points a and b of that plane, 1/3 <= |a|^2 <=
// 1, the sine of the angle is at least 3^(-1/2) |a - b|, as the area of the triangle with the origin says,
// so that |v_i - Q| >= h/12 on the sides, and off the element, as the great circle to Q crosses a side
// before; and a/|a| moves by at most 3^(1/2) times as much as a, so that |v_i - Q| <= 3^(1/2) h on it. The
// area element is r dr dphi for the distance r from v_i, as r^2 = 2 - 2 cos theta: without the cap of
// radius d the integral is 2 pi log(2/d), and so
//     2 pi log(2/(3^(1/2) h)) <= Int <= 2 pi log(24/h)      for all nodes and all levels.
// two_piece(p), p >= 1: the roof is a graph with slopes up to p: distances are at least those of the
// parameters, the area element at most (1 + p^2)^(1/2), and the other piece is at a distance of 1 or more.
// In polar coordinates of the parameters, whose square has the diameter 2^(1/2),
//     Int <= (1 + p^2)^(1/2) [2 pi log(12 2^(1/2)/h) + 1]   for all nodes and all levels.
//
// Checked      the distances of the nodes from the sides, exactly, levels 0 to 3 of both triangulations,
//              which are all similar; rejected for alpha = 1/10. Int less 2 pi log(1/h) between its bounds
//              on the sphere, for the nodes of the element in the middle of an octant and of one at its
//              corner, enclosed, levels 1 to 10: Int dphi Int r^(1-k) dr, k = 2, up to the great circles
//              of the sides. The powers k = 1 and 3 are rejected: bounded, and growing like 1/h. The
//              growth from level 9 to 10 is 2 pi log 2, and for k = 0 what is left of the sphere without
//              an octant 7 pi/2. The bound on the roof of two_piece(2) at one node, levels 2 to 4.
// Not checked  other smooth surfaces, but by these words with their charts' constants.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/enclosure/polygon_integral.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Corners = std::array<Vector<Rational>, 3>;

Vector<Rational> node_of(const Corners& v, std::size_t j, const Rational& alpha) {
  Vector<Rational> node{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) node = node + (i == j ? 1 - 2 * alpha : alpha) * v.at(i);
  return node;
}

// The least squared distance of a node from a side, over the square of the longest side.
Rational squared_distance_from_sides(const Corners& v, const Rational& alpha) {
  Rational longest(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Rational> side = v.at((i + 1) % 3) - v.at(i);
    longest = std::max(longest, dot(side, side));
  }
  Rational least = longest;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<Rational> side = v.at((i + 1) % 3) - v.at(i);
      const Vector<Rational> area = cross(side, node_of(v, j, alpha) - v.at(i));
      least = std::min(least, dot(area, area) / dot(side, side));
    }
  return least / longest;
}

Rational least_of(const std::vector<Corners>& triangles, const Rational& alpha) {
  Rational least(1);
  for (const Corners& v : triangles) least = std::min(least, squared_distance_from_sides(v, alpha));
  return least;
}

constexpr int finest_counted = 3;

std::vector<Corners> octant_triangles() {
  std::vector<Corners> all;
  for (int level = 0; level <= finest_counted; ++level)
    for (const OctantTriangle& t : symmetric_octant(level)) all.push_back(t.corners);
  return all;
}

std::vector<Corners> square_triangles() {
  const Surface surface = surface_of(linear_problem("two_piece", {{"p", 2}}, "1"));
  std::vector<Corners> all;
  for (int level = 0; level <= finest_counted; ++level)
    for (const ParameterTriangle& t : triangulate(surface, level).triangles) {
      Corners v;
      for (std::size_t i = 0; i < 3; ++i)
        v.at(i) = {Rational::exactly(t.vertices.at(i).s), Rational::exactly(t.vertices.at(i).t), 0};
      all.push_back(v);
    }
  return all;
}

// Int_rho^2 r^(1-k) dr for w = (rho/2)^2.
template <class R>
R along_a_ray(int k, const R& w) {
  const R two = R(2);
  if (k == 0) return two - two * w;
  if (k == 2) return -log(w) / two;
  const R rho = two * sqrt(w);
  return k == 1 ? two - rho : R(1) / rho - R(1) / two;
}

// Int |P - Q|^-k over the unit sphere without the triangle of great circles through the corners, P =
// node/|node| inside of it: with phi the angle at P from the foot on a side, at the angle delta from P, the
// side is at the angle theta with tan theta = tan delta/cos phi, and w = (1 - cos theta)/2.
Ball over_the_sphere(const Corners& corners, const Vector<Rational>& node, int k) {
  const auto in_balls = [](const Vector<Rational>& v) {
    return Vector<Ball>{Ball(v.x), Ball(v.y), Ball(v.z)};
  };
  const Vector<Ball> p = reciprocal(norm(in_balls(node))) * in_balls(node);
  Ball sum(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Ball> a = in_balls(corners.at(i));
    const Vector<Ball> b = in_balls(corners.at((i + 1) % 3));
    const Vector<Ball> plane = cross(a, b);
    const Ball height = abs(dot(plane, p));
    const Vector<Ball> normal =
        certainly_negative(dot(plane, p)) ? Vector<Ball>{-plane.x, -plane.y, -plane.z} : plane;
    const Vector<Ball> towards = height * p - normal;
    const Ball length = norm(towards);
    const Vector<Ball> foot = reciprocal(length) * towards;
    const Vector<Ball> across = cross(p, foot);
    const Ball t = height / length;
    const auto direction = [&](const Vector<Ball>& q) { return atan(dot(q, across) / dot(q, foot)); };
    const Ball from = direction(a);
    const Ball to = direction(b);
    const auto ray = [t, k]<class R>(const R& phi) -> R {
      const R c = cos(phi);
      const R square = c * c + R(t) * R(t);
      return along_a_ray(k, R(t) * R(t) / (R(2) * square * (R(1) + c / sqrt(square))));
    };
    sum += abs(known(integral_on_interval(line_function(ray), from, to, {.radius = 1e-12})));
  }
  return sum;
}

// The element of symmetric refinement in the middle of the octant, and the one at its corner (1,0,0).
Corners in_the_middle(int level) {
  const Rational shrunk = Rational(level % 2 == 0 ? 1 : -1) / power(Rational(2), level);
  const Rational third(1, 3);
  const Rational rest = third * (1 - shrunk);
  Corners v{Vector<Rational>{rest, rest, rest}, {rest, rest, rest}, {rest, rest, rest}};
  v[0].x = v[0].x + shrunk;
  v[1].y = v[1].y + shrunk;
  v[2].z = v[2].z + shrunk;
  return v;
}
Corners at_the_corner(int level) {
  const Rational side = 1 / power(Rational(2), level);
  return {Vector<Rational>{1, 0, 0}, {1 - side, side, 0}, {1 - side, 0, side}};
}

// h = 2^(1/2) 2^-level.
Ball mesh_size(int level) { return sqrt(Ball(2)) / power(Ball(2), level); }

// Int |v_i - Q|^-k over the sphere without the element, less 2 pi log(1/h).
Ball beyond_the_logarithm(const Corners& v, std::size_t j, int level, int k) {
  return over_the_sphere(v, node_of(v, j, Rational(1, 6)), k) + Ball(2) * Ball::pi() * log(mesh_size(level));
}

// Int |P-Q|^-k over the roof of two_piece(2) without the element with the corners (1/2,1/2), (1/2+l,1/2),
// (1/2,1/2+l) of its parameters, l = 2^-level, P its first node; and over the square below.
Ball over_two_piece(int level, int k) {
  const Rational half(1, 2);
  const Rational leg = 1 / power(Rational(2), level);
  const Rational far = half + leg;
  const ParameterPoint<Rational> at{half + leg / 6, half + leg / 6};
  const auto integrand = [&](bool on_roof) {
    return [at, k, on_roof]<class R>(const ParameterPoint<R>& q) -> R {
      const R x = from_rational<R>(at.s);
      const R d = q.s - x;
      const R e = q.t - from_rational<R>(at.t);
      const R rise = on_roof ? d * (q.s + x) : from_rational<R>(2) - x * x;
      const R square = d * d + e * e + rise * rise;
      const R area =
          on_roof ? sqrt(from_rational<R>(1) + from_rational<R>(4) * q.s * q.s) : from_rational<R>(1);
      return k == 2 ? area / square : area / (square * sqrt(square));
    };
  };
  const std::vector<ParameterPolygon> around{{{0, 0}, {half, 0}, {half, 1}, {0, 1}},
                                             {{half, 0}, {1, 0}, {1, half}, {half, half}},
                                             {{far, half}, {1, half}, {1, 1}, {half, 1}, {half, far}}};
  const Demand demand{.radius = 1e-3};
  Ball sum = known(integral_over_polygon(integrand(false), {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, demand));
  for (const ParameterPolygon& polygon : around)
    sum += known(integral_over_polygon(integrand(true), polygon, demand));
  return sum;
}

}  // namespace

Finding theorem_3_7_integral(const Bench&) {
  const BallPrecision precision(128);
  const Rational sixth(1, 6);
  const Rational tenth(1, 10);
  Finding finding;
  const std::string distance = "squared distance of nodes from sides over h^2, levels 0 to 3, ";
  finding.require(distance + "octant", IsExactly{Rational(1, 48)}, least_of(octant_triangles(), sixth));
  finding.require(distance + "unit squares", IsExactly{Rational(1, 144)},
                  least_of(square_triangles(), sixth));
  finding.control(distance + "octant, alpha = 1/10", IsExactly{Rational(1, 48)},
                  least_of(octant_triangles(), tenth));
  // 2 pi log(2/3^(1/2)) = 0.9038..., 2 pi log 24 = 19.968...
  const LiesIn bounds{Rational(9, 10), 20};
  const std::string sphere = "Int |v_i - Q|^-2 less 2 pi log(1/h), sphere, ";
  struct Place {
    std::string name;
    Corners (*element)(int level);
    std::size_t node;
  };
  for (const Place& place : {Place{"middle", in_the_middle, 0}, Place{"corner", at_the_corner, 0},
                             Place{"corner", at_the_corner, 1}})
    for (const int level : {1, 2, 4, 6, 8, 10})
      finding.require(sphere + "node " + std::to_string(place.node) + " of the element at the " + place.name +
                          " of an octant, level " + std::to_string(level),
                      bounds, beyond_the_logarithm(place.element(level), place.node, level, 2));
  for (const int k : {1, 3})
    finding.control("the same with |v_i - Q|^-" + std::to_string(k) + ", level 8", bounds,
                    beyond_the_logarithm(in_the_middle(8), 0, 8, k));
  const auto growth = [](int k) {
    const auto of = [k](int level) {
      return over_the_sphere(in_the_middle(level), node_of(in_the_middle(level), 0, Rational(1, 6)), k);
    };
    return of(10) - of(9);
  };
  // The area of the sphere less that of an octant.
  const AgreesWith area{.value = Ball(Rational(7, 2)) * Ball::pi(), .within = 1e-10};
  const auto without_an_octant = [&](int k) { return over_the_sphere(in_the_middle(0), {1, 2, 3}, k); };
  finding.require("Int 1 over the sphere without an octant, seen from (1,2,3)/14^(1/2)", area,
                  without_an_octant(0));
  finding.control("Int |v_i - Q|^-1 there", area, without_an_octant(1));
  const AgreesWith logarithmic{.value = Ball(2) * Ball::pi() * log(Ball(2)), .within = 0.01};
  finding.require("growth from level 9 to 10, sphere, against 2 pi log 2", logarithmic, growth(2));
  for (const int k : {1, 3})
    finding.control("the same with |v_i - Q|^-" + std::to_string(k), logarithmic, growth(k));
  const auto beyond_the_bound = [](int level, int k) {
    const Ball bound =
        sqrt(Ball(5)) * (Ball(2) * Ball::pi() * log(Ball(12) * sqrt(Ball(2)) / mesh_size(level)) + Ball(1));
    return proved(over_two_piece(level, k) - bound);
  };
  for (int level = 2; level <= 4; ++level)
    finding.require("Int |v_i - Q|^-2 less its bound, two_piece(2), level " + std::to_string(level), AtMost{},
                    beyond_the_bound(level, 2));
  finding.control("the same with |v_i - Q|^-3, level 4", AtMost{}, beyond_the_bound(4, 3));
  finding.show(proved(growth(2)));
  return finding;
}

}  // namespace radcert::verification::ac98
