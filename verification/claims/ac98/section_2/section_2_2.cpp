// SPDX-License-Identifier: GPL-3.0-or-later

// What section 2.2 says in words of surfaces with edges.
//
// Checked      section_2_2_box: on the boundary of [0,a] x [0,b] x [0,c], for each of the twelve edges, the
//              two points at the distance z from any point of it, one on either face, have G = 1/(4z^2):
//              identities in a, b, c, z and the place on the edge. section_2_2_lemma_2_1: the integral over
//              (20) is no pi, at points; it is below pi/2 at all, by equation_15. equation_22_corner: with x
//              and 1-x > 0, z > 0 and atan t <= t,
//                  |(22) - (pi - atan(z/x))/2| <= (z/2) (1/(1-x) + 1),
//              so that along z = k x (22) tends to (pi - atan k)/2, which depends on k: K 1 has no limit at
//              the ends of the edge, and at its other points it has pi/2; that bound, and how far two ways
//              stay apart, at points as close as 2^-60. The derivative by x has the part z/(2 (x^2 + z^2)),
//              1/(4x) at z = x. equation_23_corner: with the logarithm L of the form near the edge, (4/z)(23)
//              - L = log{(1 + z^2/(1-x)^2) (1 + z^2/(1+x^2))/((1 + z^2/(1+(1-x)^2)) (1 + z^2/x^2))}, an
//              identity of the quotients: at z = x it tends to -log 2 as x -> 0, so that the remainder of the
//              form is not O(z^3) there, while L tends to infinity, and (4/z)(23) at x = 0 does not.
// Not checked  x near 1, but by x -> 1 - x, which leaves (22) as it is and turns the sign of (23) and of L.

#include <array>

#include "radcert/closed_form/two_squares.h"
#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Five = std::array<Rational, 5>;
using Point = std::array<Rational, 3>;

Vector<Rational> vector_of(const Point& p) { return {p[0], p[1], p[2]}; }

// An edge of the box: it runs along one axis, and lies at the low or the high end of the two others.
struct Edge {
  std::size_t axis;
  bool high_first;
  bool high_second;
};

// G between the points at the distance z from a point of an edge, on its two faces, or on one of them.
Rational kernel_across(const Edge& edge, const Five& x, bool one_face) {
  const Rational& z = x[3];
  const std::size_t first = (edge.axis + 1) % 3;
  const std::size_t second = (edge.axis + 2) % 3;
  Point base{0, 0, 0};
  base.at(edge.axis) = x[4];  // any place on the edge
  base.at(first) = edge.high_first ? x.at(first) : Rational(0);
  base.at(second) = edge.high_second ? x.at(second) : Rational(0);
  // The inner normal of the face on which a coordinate has its low or high end.
  const auto inwards = [&](std::size_t which, bool high) {
    Point n{0, 0, 0};
    n.at(which) = high ? -1 : 1;
    return vector_of(n);
  };
  const Vector<Rational> along_first = inwards(first, edge.high_first);
  const Vector<Rational> along_second = inwards(second, edge.high_second);
  const Vector<Rational> p = vector_of(base) + z * along_first;
  const Vector<Rational> q = vector_of(base) + (one_face ? 2 * z * along_first : z * along_second);
  return geometric_kernel(p, along_second, q, one_face ? along_second : along_first);
}

Rational differing_edges(bool one_face) {
  constexpr long values = 5;  // 4 z^2 times the numerator less |P-Q|^4 is of degree 4 in z
  Rational count = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool high_first : {false, true})
      for (const bool high_second : {false, true})
        count += differing_on_grid<5>(
            values,
            [&](const Five& x) {
              return kernel_across({axis, high_first, high_second}, x, one_face);
            },
            [](const Five& x) { return 1 / (4 * x[3] * x[3]); });
  return count;
}

Ball one_at(const Rational& x, const Rational& z) { return TwoSquares<Ball>(Ball(x), Ball(z)).one(); }

// The quotient of (23), with or without z^2.
Rational quotient(const Rational& x, const Rational& q) {
  const Rational a = 1 - x;
  return (a * a + q) * (x * x + 1 + q) / ((a * a + 1 + q) * (x * x + q));
}

}  // namespace

Finding section_2_2_box(const Bench&) {
  Finding finding;
  finding.require("edges, places on them and lengths where G differs from 1/(4 z^2)", IsExactly{0},
                  differing_edges(false));
  finding.control("edges, places and lengths where G between two points of one face does", IsExactly{0},
                  differing_edges(true));
  return finding;
}

Finding section_2_2_lemma_2_1(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  const AgreesWith pi{.value = Ball::pi(), .within = 1e-30};
  for (const auto& [x, z] : {std::array<Rational, 2>{Rational(1, 2), Rational(1, 2)},
                             {Rational(1, 3), Rational(1, 1000)},
                             {Rational(9, 10), Rational(4, 5)}})
    finding.require("integral of G over (20), x = " + x.to_text() + ", z = " + z.to_text(), pi, one_at(x, z));
  const Polyhedron cube = cube_polyhedron();
  const Rational radius = 1 / power(Rational(10), 32);
  const Vector<Rational> floor_point{Rational(1, 3), Rational(1, 1000), 0};
  finding.instead("integral of G over the cube, of which (20) is a part, at (1/3,1/1000,0)", pi,
                  total_factor(cube, floor_face, floor_point, radius));
  Polyhedron open = cube;
  open.faces.pop_back();
  finding.control("integral of G over the cube without a wall", pi,
                  total_factor(open, floor_face, floor_point, radius));
  finding.show(proved(one_at(Rational(1, 2), Rational(1, 2))));
  return finding;
}

Finding equation_22_corner(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  const Ball half_pi = Ball::pi() / Ball(2);
  for (const int halvings : {10, 60}) {
    const Rational x = 1 / power(Rational(2), halvings);
    const std::string at = ", x = 2^-" + std::to_string(halvings);
    for (const Rational& k : {Rational(1, 4), Rational(1), Rational(4)}) {
      const Rational z = k * x;
      const Ball limit = half_pi - atan(Ball(k)) / Ball(2);
      finding.require("|(22) - (pi - atan k)/2| less (z/2) (1/(1-x) + 1), k = " + k.to_text() + at, AtMost{},
                      proved(abs(one_at(x, z) - limit) - Ball(z / 2 * (1 / (1 - x) + 1))));
    }
    // (atan 4 - atan(1/4))/2 > 1/4, and in the middle of the edge nothing is left of it.
    const Rational quarter(1, 4);
    const Rational half(1, 2);
    finding.require("1/4 less (22) at z = x/4 and at z = 4x" + at, AtMost{},
                    proved(Ball(quarter) - abs(one_at(x, x / 4) - one_at(x, 4 * x))));
    finding.control("the same at the heights x/4 and 4x over the middle of the edge" + at, AtMost{},
                    proved(Ball(quarter) - abs(one_at(half, x / 4) - one_at(half, 4 * x))));
  }
  using One = std::array<Rational, 1>;
  const auto steep = [](const Rational& k) {
    return [k](const One& x) { return k * x[0] / (2 * (x[0] * x[0] + k * k * x[0] * x[0])); };
  };
  const auto grows = [](const One& x) { return 1 / (4 * x[0]); };
  finding.require("points of z = x where z/(2 (x^2 + z^2)) differs from 1/(4x)", IsExactly{0},
                  differing_on_grid<1>(5, steep(1), grows));
  finding.control("points of z = 2x where it does", IsExactly{0}, differing_on_grid<1>(5, steep(2), grows));
  finding.show(proved(one_at(1 / power(Rational(2), 60), 1 / power(Rational(2), 60))));
  return finding;
}

Finding equation_23_corner(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  using Two = std::array<Rational, 2>;
  constexpr long values = 20;  // degrees of 16 at most in x and in z
  const auto factors = [](const Rational& sign) {
    return [sign](const Two& at) {
      const Rational& x = at[0];
      const Rational a = 1 - x;
      const Rational q = at[1] * at[1];
      return (1 + q / (a * a)) * (1 + q / (1 + x * x)) / ((1 + q / (1 + a * a)) * (1 + sign * q / (x * x)));
    };
  };
  const auto of_quotients = [](const Two& at) { return quotient(at[0], at[1] * at[1]) / quotient(at[0], 0); };
  finding.require("points where the quotients of (23) and of its form near the edge differ by other factors",
                  IsExactly{0}, differing_on_grid<2>(values, of_quotients, factors(1)));
  finding.control("points where they differ by other factors than with 1 + z^2/(4x^2)", IsExactly{0},
                  differing_on_grid<2>(values, of_quotients, factors(Rational(1, 4))));
  const auto beyond = [](const Rational& x, const Rational& z) {
    return Ball(4) / Ball(z) * TwoSquares<Ball>(Ball(x), Ball(z)).offset() - log(Ball(quotient(x, 0)));
  };
  for (const int halvings : {10, 60}) {
    const Rational x = 1 / power(Rational(2), halvings);
    const std::string at = ", x = 2^-" + std::to_string(halvings);
    // Three factors are 1 up to 2 x^2 at z = x, and the fourth is 2.
    finding.require("|(4/z)(23) - L + log 2| at z = x, less 8 x^2" + at, AtMost{},
                    proved(abs(beyond(x, x) + log(Ball(2))) - Ball(8 * x * x)));
    finding.control("the same over x = 1/2, at that height" + at, AtMost{},
                    proved(abs(beyond(Rational(1, 2), x) + log(Ball(2))) - Ball(8 * x * x)));
    // x^2 in the denominator of the quotient is all that is small.
    finding.require("2 log(1/x) - 1 less L" + at, AtMost{},
                    proved(Ball(2) * log(reciprocal(Ball(x))) - Ball(1) - log(Ball(quotient(x, 0)))));
  }
  finding.show(proved(beyond(1 / power(Rational(2), 60), 1 / power(Rational(2), 60))));
  return finding;
}

}  // namespace radcert::verification::ac98
