// SPDX-License-Identifier: GPL-3.0-or-later

// An affine map (56) takes polynomials to polynomials of the same degree and multiplies every integral by the
// same number, so the degree of precision of (58) is that of (54) on every triangle.
//
// Checked      In exact arithmetic, on triangles of both orientations, right-angled, scalene and very thin:
//              the integrals of x^a y^b by Green's theorem along the sides, the rule typed in as printed. The
//              degree is 2 and no more on each.
// Not checked  other triangles by themselves: the argument above speaks for them.

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

}  // namespace

Finding equation_58(const Bench&) {
  Finding finding;
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
