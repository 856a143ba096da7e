// SPDX-License-Identifier: GPL-3.0-or-later

// (48) from the error of linear interpolation. On a triangle of the diameter h let p_1 be the Taylor
// polynomial of f at the centroid c, and M the largest second derivative of f along a line. L reproduces p_1,
// so that (I - L)f = (I - L)(f - p_1), |f(x) - p_1(x)| <= |x - c|^2 M/2, and |x - c| <= 2h/3: the median to a
// side a is, squared, (2b^2 + 2c^2 - a^2)/4 <= h^2, and the centroid has two thirds of it before it. With the
// norm (1 + alpha)/(1 - 3 alpha) of L
//     |f - L f| <= (1 + (1 + alpha)/(1 - 3 alpha)) (2/9) h^2 M,
// for every f of C^2 and every alpha. By (49) norm of (u - hat u_n) <= c norm of K times this for f = u(m_k)
// on the parameter triangles, which needs charts and u in C^2.
//
// Checked      the median and the place of the centroid, as a polynomial identity in the corners, b^2 and c^2
//              being at most h^2. That L reproduces linear functions, as an identity in alpha. Beside these,
//              from which the bound follows for every f, triangle and alpha, the bound itself at polynomials
//              of degree 2, for which M is known, on two triangles, alpha = 0, 1/10 and 1/6; for
//              interpolation by constants, whose error is O(h), it is rejected.
// Not checked  Taylor's theorem; the norm of L, (49) and the norm of K: equation_37, equation_49,
//              equation_17.

#include <algorithm>
#include <array>

#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Four = std::array<Rational, 4>;

Rational squared(const PlanarPoint& p) { return p.x * p.x + p.y * p.y; }
PlanarPoint difference(const PlanarPoint& p, const PlanarPoint& q) { return {p.x - q.x, p.y - q.y}; }

// Triangles with the corners 0, p and q where the squared distance of the centroid from 0 is not a multiple
// of what the sides say of the median.
Rational differing_medians(const Rational& part) {
  constexpr long values = 3;
  const auto corners = [](const Four& x) {
    return std::array<PlanarPoint, 2>{PlanarPoint{x[0], x[1]}, PlanarPoint{x[2], x[3]}};
  };
  return differing_on_grid<4>(
      values,
      [&](const Four& x) {
        const auto [p, q] = corners(x);
        return squared({(p.x + q.x) / 3, (p.y + q.y) / 3});
      },
      [&](const Four& x) {
        const auto [p, q] = corners(x);
        return part * (2 * squared(p) + 2 * squared(q) - squared(difference(p, q))) / 4;
      });
}

// (I - L)f for f = s + a s^2 + b s t + c t^2, largest over points with barycentric coordinates i/12 of the
// triangle (0,0), (h,0), (0,h), less the bound with (|a| + |b| + |c|) 2 >= M and the longest side, squared,
// 2h^2.
Rational over_the_bound(const Rational& a, const Rational& b, const Rational& c, const Rational& h,
                        const Rational& alpha, bool degree_0) {
  const PlanarTriangle tau{PlanarPoint{0, 0}, PlanarPoint{h, 0}, PlanarPoint{0, h}};
  const ExactPolynomial f = ExactPolynomial::monomial(1, 0) +
                            ExactPolynomial(a) * ExactPolynomial::monomial(2, 0) +
                            ExactPolynomial(b) * ExactPolynomial::monomial(1, 1) +
                            ExactPolynomial(c) * ExactPolynomial::monomial(0, 2);
  const ExactPolynomial error =
      f - (degree_0 ? ExactPolynomial(f(PlanarPoint{h / 3, h / 3})) : interpolant(tau, alpha, f));
  constexpr long parts = 12;
  Rational largest = 0;
  for (long i = 0; i <= parts; ++i)
    for (long j = 0; i + j <= parts; ++j)
      largest = std::max(largest, abs(error({h * Rational(i, parts), h * Rational(j, parts)})));
  const Rational norm = (1 + alpha) / (1 - 3 * alpha);
  const Rational beyond = largest / ((1 + norm) * Rational(4, 9) * h * h) - abs(a + c);
  return beyond.sign() <= 0 ? beyond : beyond * beyond - ((a - c) * (a - c) + b * b);
}

// Terms in which sum q_i l_i(x), barycentric coordinates with the sum 1, differs from x, and sum l_i(x) from
// 1, for the nodes (33) and l_i = (x_i - alpha)/(1 - 3 alpha), or for l_i = x_i.
Rational not_reproduced(bool at_vertices) {
  using Function = RationalFunction;
  const Function alpha = Function::variable("alpha");
  const Function first = Function::variable("x1");
  const Function second = Function::variable("x2");
  const std::array<Function, 3> x{first, second, 1 - first - second};
  const auto lagrange = [&](std::size_t i) {
    return at_vertices ? x.at(i) : (x.at(i) - alpha) / (1 - 3 * alpha);
  };
  Rational terms = differing_terms(lagrange(0) + lagrange(1) + lagrange(2), 1);
  for (std::size_t k = 0; k < x.size(); ++k) {
    Function value(0);
    for (std::size_t i = 0; i < x.size(); ++i) value += lagrange(i) * (i == k ? 1 - 2 * alpha : alpha);
    terms += differing_terms(value, x.at(k));
  }
  return terms;
}

Rational quadratics_over_the_bound(const Rational& alpha, bool degree_0) {
  long count = 0;
  for (const Rational& h : {Rational(1), Rational(1, 1000)})
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b)
        for (int c = -1; c <= 1; ++c)
          if (over_the_bound(a, b, c, h, alpha, degree_0).sign() > 0) ++count;
  return {count};
}

}  // namespace

Finding theorem_3_1_interpolation(const Bench&) {
  Finding finding;
  finding.require("triangles whose centroid is not at 2/3 of the median that the sides give", IsExactly{0},
                  differing_medians(Rational(4, 9)));
  finding.control("triangles whose centroid is not at 1/2 of it", IsExactly{0},
                  differing_medians(Rational(1, 4)));
  finding.require("terms in which L takes linear functions to others, all alpha", IsExactly{0},
                  not_reproduced(false));
  finding.control("the same for the functions of the vertices at these nodes", IsExactly{0},
                  not_reproduced(true));
  for (const Rational& alpha : {Rational(0), Rational(1, 10), Rational(1, 6)})
    finding.require(
        "polynomials of degree 2 and triangles whose error exceeds the bound, alpha = " + alpha.to_text(),
        IsExactly{0}, quadratics_over_the_bound(alpha, false));
  finding.control("those whose error exceeds the bound of alpha = 0 for interpolation by constants",
                  IsExactly{0}, quadratics_over_the_bound(0, true));
  return finding;
}

}  // namespace radcert::verification::ac98
