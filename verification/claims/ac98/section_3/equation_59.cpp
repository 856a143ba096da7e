// SPDX-License-Identifier: GPL-3.0-or-later

// An affine map takes the unit square of (55) to every parallelogram and its two triangles to those of the
// parallelogram, so the degree of precision of (59) is that of (55).
//
// Checked      In exact arithmetic, that the rules are exact for degree 3 on all parallelograms, as an
//              identity of polynomials in their sides; on a square, a rectangle, an oblique and a very thin
//              parallelogram, cut along either diagonal: the integrals by Green's theorem along the sides,
//              the rules of the triangles typed in as printed. The degree is 3 and no more on each, so by the
//              affine map on all. Two triangles whose union is a quadrilateral but no parallelogram are
//              rejected.
// Not checked  two triangles that share no side.

#include "verification/claims/ac98/surfaces/planar_rule.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Quadrilateral = std::array<PlanarPoint, 4>;

// p, p + a, p + a + b, p + b.
Quadrilateral parallelogram(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  return {p, {p.x + a.x, p.y + a.y}, {p.x + a.x + b.x, p.y + a.y + b.y}, {p.x + b.x, p.y + b.y}};
}

// The rules of both triangles, cut from vertex `from` to the opposite one.
PlanarRule cut(const Quadrilateral& q, std::size_t from, const Rational& alpha) {
  const auto at = [&](std::size_t i) { return q[(from + i) % 4]; };
  return together(printed_rule({at(0), at(1), at(2)}, alpha), printed_rule({at(0), at(2), at(3)}, alpha));
}

std::vector<PlanarPoint> polygon(const Quadrilateral& q) { return {q.begin(), q.end()}; }

Rational precision_on(const Quadrilateral& q, std::size_t from, const Rational& alpha) {
  return precision(cut(q, from, alpha), polygon(q));
}

struct NamedParallelogram {
  std::string name;
  Quadrilateral corners;
};

std::vector<NamedParallelogram> parallelograms() {
  return {{"the unit square", parallelogram({0, 0}, {1, 0}, {0, 1})},
          {"a rectangle", parallelogram({-3, Rational(1, 2)}, {7, 0}, {0, Rational(2, 9)})},
          {"an oblique one", parallelogram({4, Rational(-5, 3)}, {Rational(7, 2), 1}, {-2, Rational(11, 4)})},
          {"a very thin one", parallelogram({1, 1}, {1000000, 1}, {1000000, 2})}};
}

// Parallelograms of a grid on which some x^a y^b, a + b <= 3, is not integrated exactly. With a corner at 0
// and the sides a and b rule and integral are polynomials of degree 4 at most in each of their coordinates:
// area times a cubic polynomial. Five values of each prove an identity; moving the corner keeps the space of
// cubic polynomials.
Rational parallelograms_missed(std::size_t from, const Rational& alpha) {
  constexpr long values = 5;
  constexpr long apart = 10;  // so that none of the grid is turned over
  long count = 0;
  for (long i = 0; i < values; ++i)
    for (long j = 0; j < values; ++j)
      for (long k = 0; k < values; ++k)
        for (long l = 0; l < values; ++l) {
          const Quadrilateral each = parallelogram({0, 0}, {apart + i, j}, {k, apart + l});
          const PlanarRule rule = cut(each, from, alpha);
          bool exact = true;
          for (int degree = 0; degree <= 3; ++degree)
            for (int b = 0; b <= degree; ++b)
              exact = exact && missed(rule, polygon(each), degree - b, b) == 0;
          if (!exact) ++count;
        }
  return {count};
}

}  // namespace

Finding equation_59(const Bench&) {
  Finding finding;
  const Rational sixth(1, 6);
  for (const std::size_t from : {0U, 1U}) {
    const std::string diagonal = from == 0 ? "" : ", the other diagonal";
    finding.require("parallelograms of the grid where a polynomial of degree 3 is missed" + diagonal,
                    IsExactly{0}, parallelograms_missed(from, sixth));
    finding.control("the same for alpha = 1/10" + diagonal, IsExactly{0},
                    parallelograms_missed(from, Rational(1, 10)));
  }
  for (const NamedParallelogram& each : parallelograms())
    for (const std::size_t from : {0U, 1U}) {
      const std::string where = each.name + (from == 0 ? "" : ", the other diagonal");
      const PlanarRule rule = cut(each.corners, from, sixth);
      for (int degree = 0; degree <= 3; ++degree)
        for (int b = 0; b <= degree; ++b)
          finding.require("rule minus integral, x^" + std::to_string(degree - b) + " y^" + std::to_string(b) +
                              ", " + where,
                          IsExactly{0}, missed(rule, polygon(each.corners), degree - b, b));
      finding.require("degree of precision, " + where, IsExactly{3}, precision_on(each.corners, from, sixth));
      finding.control("degree of precision, alpha = 1/10, " + where, IsExactly{3},
                      precision_on(each.corners, from, Rational(1, 10)));
    }
  const Quadrilateral trapezium{{{0, 0}, {3, 0}, {2, 1}, {1, 1}}};
  finding.control("degree of precision, a trapezium", IsExactly{3}, precision_on(trapezium, 0, sixth));
  finding.show({.value = 3, .radius = 0, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::ac98
