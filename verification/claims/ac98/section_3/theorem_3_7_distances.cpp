// SPDX-License-Identifier: GPL-3.0-or-later

// Of a triangle that is cut N times along each side the pairs through sides of one direction leave the N
// upright triangles that lie along that side of it (equation_79_pairs); the element of v_i, which is taken
// out, leaves its partner as well. Which direction serves may be chosen for each v_i: that of the side
// farthest from it, which is at least as far as the radius of the inscribed circle, 1/(2 + 2^(1/2)) = 0.29
// for the unit triangle. What is left over lies within 1/N of that side, so that from N = 8 on it is more
// than 1/7 away from v_i. In the other triangles of level 0 the same holds with another number, as no point
// lies on all three sides of one.
//
// Checked      theorem_3_7_distances: the triangles left over within 1/7 of v_i, for all nodes of the unit
//              triangle, N = 8 and 16, alpha = 1/6, exactly: none with the side that is farthest, and more
//              and more with one side for all.
// Not checked  the triangles of other charts, but by the argument above.

#include <algorithm>
#include <array>
#include <vector>

#include "radcert/scalar/real.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

Rational square_of_distance(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  const PlanarPoint along{b.x - a.x, b.y - a.y};
  const PlanarPoint to{p.x - a.x, p.y - a.y};
  const Rational foot = (to.x * along.x + to.y * along.y) / (along.x * along.x + along.y * along.y);
  const Rational t = std::min(Rational(1), std::max(Rational(0), foot));
  const Rational x = to.x - t * along.x;
  const Rational y = to.y - t * along.y;
  return x * x + y * y;
}

// Of a point outside, from the triangle.
Rational square_of_distance(const PlanarPoint& p, const PlanarTriangle& triangle) {
  return std::min({square_of_distance(p, triangle[0], triangle[1]),
                   square_of_distance(p, triangle[1], triangle[2]),
                   square_of_distance(p, triangle[2], triangle[0])});
}

// The sides s = 0, t = 0 and s + t = 1.
enum class Side { left, lower, upper };
constexpr std::array sides{Side::left, Side::lower, Side::upper};

Rational square_of_distance(const PlanarPoint& p, Side side) {
  if (side == Side::left) return p.x * p.x;
  if (side == Side::lower) return p.y * p.y;
  const Rational rest = 1 - p.x - p.y;
  return rest * rest / 2;
}

PlanarTriangle upright(long i, long j, long n) {
  return {PlanarPoint{Rational(i, n), Rational(j, n)}, PlanarPoint{Rational(i + 1, n), Rational(j, n)},
          PlanarPoint{Rational(i, n), Rational(j + 1, n)}};
}

PlanarTriangle turned(long i, long j, long n) {
  return {PlanarPoint{Rational(i + 1, n), Rational(j + 1, n)},
          PlanarPoint{Rational(i, n), Rational(j + 1, n)}, PlanarPoint{Rational(i + 1, n), Rational(j, n)}};
}

std::vector<PlanarTriangle> along(Side side, long n) {
  std::vector<PlanarTriangle> strip;
  for (long k = 0; k < n; ++k) {
    if (side == Side::left) strip.push_back(upright(0, k, n));
    if (side == Side::lower) strip.push_back(upright(k, 0, n));
    if (side == Side::upper) strip.push_back(upright(k, n - 1 - k, n));
  }
  return strip;
}

enum class Choice { farthest_side, lower_side };

// The most triangles left over within 1/7 of a node, its own element and that one's partner not counted.
Rational most_nearby(long n, Choice choice) {
  const Rational near(1, 49);
  const Rational sixth(1, 6);
  std::array<std::vector<PlanarTriangle>, 3> strips;
  for (std::size_t k = 0; k < 3; ++k) strips.at(k) = along(sides.at(k), n);
  std::vector<PlanarTriangle> elements;
  for (long i = 0; i < n; ++i)
    for (long j = 0; i + j < n; ++j) {
      elements.push_back(upright(i, j, n));
      if (i + j + 1 < n) elements.push_back(turned(i, j, n));
    }
  long most = 0;
  for (const PlanarTriangle& element : elements)
    for (const PlanarPoint& node : printed_rule(element, sixth).points) {
      std::size_t chosen = 1;
      if (choice == Choice::farthest_side)
        for (std::size_t k = 0; k < 3; ++k)
          if (square_of_distance(node, sides.at(k)) > square_of_distance(node, sides.at(chosen))) chosen = k;
      const long count =
          std::count_if(strips.at(chosen).begin(), strips.at(chosen).end(), [&](const PlanarTriangle& each) {
            const bool own =
                each[0].x == element[0].x && each[0].y == element[0].y && each[1].x == element[1].x;
            return !own && square_of_distance(node, each) < near;
          });
      most = std::max(most, count);
    }
  return {most};
}

}  // namespace

Finding theorem_3_7_distances(const Bench&) {
  Finding finding;
  const IsExactly zero{0};
  // 1/(2 + 2^(1/2)) = 1 - 2^(1/2)/2 > 1/7 + 1/8, where (1 - 1/7 - 1/8)^2 > 1/2.
  const Rational rest = 1 - Rational(1, 7) - Rational(1, 8);
  finding.require("whether the radius 1 - 2^(1/2)/2 of the inscribed circle is not above 1/7 + 1/8", zero,
                  Rational(rest * rest > Rational(1, 2) ? 0 : 1));
  for (const long n : {8, 16}) {
    const std::string of = ", N = " + std::to_string(n);
    finding.require("triangles left over within 1/7 of a node, pairs through the farthest side" + of, zero,
                    most_nearby(n, Choice::farthest_side));
    finding.control("the same, pairs through one side for all nodes" + of, zero,
                    most_nearby(n, Choice::lower_side));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
