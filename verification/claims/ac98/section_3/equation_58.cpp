// SPDX-License-Identifier: GPL-3.0-or-later

// An affine map (56) takes polynomials to polynomials of the same degree and multiplies every integral by the
// same number, so the degree of precision of (58) is that of (54) on every triangle.
//
// Checked      In exact arithmetic, for all triangles at once: in barycentric coordinates the quadratic
//              polynomials are spanned by x_i x_j, whose integrals are Dirichlet's, and the rule takes them
//              at the nodes: no difference. x_1^3 is missed by the 540th part of the area, so that the degree
//              is 2 and no more on each triangle. A second time as an identity of polynomials in the corners,
//              and on triangles of both orientations, right-angled, scalene and very thin: the integrals of
//              x^a y^b by Green's theorem along the sides, the rule typed in as printed.
// Not checked  regions with curved sides, to which (58) does not apply.

#include "radcert/scalar/real.h"
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

// Triangles of a grid on which some x^a y^b, a + b <= 2, is not integrated exactly. With v_3 = 0 and the
// others in one order rule and integral are polynomials of degree 3 at most in each coordinate of v_1 and
// v_2: area times a quadratic polynomial. Four values of each prove an identity, for all triangles with v_3 =
// 0; moving v_3 keeps the space of quadratic polynomials, and the other order changes neither side.
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

// Int x_1^i x_2^j x_3^k over the area: 2 i! j! k!/(i + j + k + 2)!, by Dirichlet.
Rational dirichlet(const std::array<int, 3>& exponents) {
  const auto factorial = [](int n) {
    Rational product = 1;
    for (int m = 2; m <= n; ++m) product *= m;
    return product;
  };
  Rational result = 2 / factorial(exponents[0] + exponents[1] + exponents[2] + 2);
  for (const int exponent : exponents) result *= factorial(exponent);
  return result;
}

// The rule over the area less that.
Rational missed_in_barycentric(const std::array<int, 3>& exponents, const Rational& alpha) {
  Rational sum = 0;
  for (std::size_t node = 0; node < 3; ++node) {
    Rational value = 1;
    for (std::size_t i = 0; i < 3; ++i) value *= power(i == node ? 1 - 2 * alpha : alpha, exponents.at(i));
    sum += value / 3;
  }
  return sum - dirichlet(exponents);
}

}  // namespace

Finding equation_58(const Bench&) {
  Finding finding;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      std::array<int, 3> exponents{0, 0, 0};
      ++exponents.at(i);
      ++exponents.at(j);
      const std::string product =
          "rule minus integral, over the area, x_" + std::to_string(i + 1) + " x_" + std::to_string(j + 1);
      finding.require(product, IsExactly{0}, missed_in_barycentric(exponents, Rational(1, 6)));
      finding.control(product + ", alpha = 1/10", IsExactly{0},
                      missed_in_barycentric(exponents, Rational(1, 10)));
    }
  finding.require("rule minus integral, over the area, x_1^3: no degree more", IsExactly{Rational(1, 540)},
                  missed_in_barycentric({3, 0, 0}, Rational(1, 6)));
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
