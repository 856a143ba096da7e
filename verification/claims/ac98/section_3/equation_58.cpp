// SPDX-License-Identifier: GPL-3.0-or-later

// An affine map (56) takes polynomials to polynomials of the same degree and multiplies every integral by the
// same number, so the degree of precision of (58) is that of (54) on every triangle.
//
// Checked      In exact arithmetic, that the rule is exact for degree 2 on all triangles, as an identity of
//              polynomials in the corners; on triangles of both orientations, right-angled, scalene and very thin:
//              the integrals of x^a y^b by Green's theorem along the sides, the rule typed in as printed. The
//              degree is 2 and no more on each.
// Not checked  that the degree is no more on other triangles: the argument above speaks for them.

#include "verification/claims/ac98/surfaces/planar_rule.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

struct NamedTriangle {
  std::string name;
  std::array<PlanarPoint, 3> vertices;
};

std::vector<NamedTriangle> triangles() {
  return {
      {"right-angled", {{{1, 0}, {0, 1}, {0, 0}}}},
      {"the other way round", {{{0, 1}, {1, 0}, {0, 0}}}},
      {"scalene, away from the origin", {{{Rational(7, 3), -2}, {5, Rational(9, 4)}, {Rational(-1, 5), 8}}}},
      {"a million times as long as wide", {{{-1000000, 3}, {1000000, 4}, {Rational(1, 7), Rational(9, 2)}}}}};
}

Rational precision_on(const std::array<PlanarPoint, 3>& triangle, const Rational& alpha) {
  return precision(printed_rule(triangle, alpha), {triangle.begin(), triangle.end()});
}

// Triangles of a grid on which some x^a y^b, a + b <= 2, is not integrated exactly. With v_3 = 0 and the others
// in one order rule and integral are polynomials of degree 3 at most in each coordinate of v_1 and v_2: area
// times a quadratic polynomial. Four values of each prove an identity, for all triangles with v_3 = 0; moving
// v_3 keeps the space of quadratic polynomials, and the other order changes neither side.
Rational triangles_missed(const Rational& alpha) {
  constexpr long values = 4;
  constexpr long apart = 10;  // so that no triangle of the grid is turned over
  long count = 0;
  for (long i = 0; i < values; ++i)
    for (long j = 0; j < values; ++j)
      for (long k = 0; k < values; ++k)
        for (long l = 0; l < values; ++l) {
          const std::array<PlanarPoint, 3> triangle{{{apart + i, j}, {k, apart + l}, {0, 0}}};
          const PlanarRule rule = printed_rule(triangle, alpha);
          const std::vector<PlanarPoint> polygon(triangle.begin(), triangle.end());
          bool exact = true;
          for (int degree = 0; degree <= 2; ++degree)
            for (int b = 0; b <= degree; ++b) exact = exact && missed(rule, polygon, degree - b, b) == 0;
          if (!exact) ++count;
        }
  return {count};
}

}  // namespace

Finding equation_58(const Bench&) {
  Finding finding;
  finding.require("triangles of the grid where a polynomial of degree 2 is missed", IsExactly{0},
                  triangles_missed(Rational(1, 6)));
  finding.control("the same for alpha = 1/10", IsExactly{0}, triangles_missed(Rational(1, 10)));
  for (const NamedTriangle& each : triangles()) {
    const std::vector<PlanarPoint> polygon(each.vertices.begin(), each.vertices.end());
    const PlanarRule rule = printed_rule(each.vertices, Rational(1, 6));
    for (int degree = 0; degree <= 2; ++degree)
      for (int b = 0; b <= degree; ++b)
        finding.require("rule minus integral, x^" + std::to_string(degree - b) + " y^" + std::to_string(b) +
                            ", " + each.name,
                        IsExactly{0}, missed(rule, polygon, degree - b, b));
    finding.require("degree of precision, " + each.name, IsExactly{2},
                    precision_on(each.vertices, Rational(1, 6)));
    finding.control("degree of precision, alpha = 1/10, " + each.name, IsExactly{2},
                    precision_on(each.vertices, Rational(1, 10)));
  }
  finding.show({.value = 2, .radius = 0, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::ac98
