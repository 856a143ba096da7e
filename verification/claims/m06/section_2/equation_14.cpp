// SPDX-License-Identifier: GPL-3.0-or-later

// The nodes (13) are the principal lattice, scaled by 1 - 3 alpha about the centroid. On P_r the scaling has
// the eigenvalue (1 - 3 alpha)^k on the k + 1 polynomials of degree k, so that the determinant of the nodes
// is that of the lattice times (1 - 3 alpha)^(r (r + 1)(r + 2)/3): not zero for any alpha other than 1/3.
//
// Checked      for r = 0 to 4 (5 beyond quick) and four alphas, exactly: this determinant, and that it is not
//              zero, so that one polynomial of degree <= r interpolates and no other; sum g(q_j) l_j = g for
//              every monomial g of degree <= r, at as many points as settle an equality in P_r, on the
//              reference triangle and on a scalene one, (27); not for s^(r+1). Two nodes in one place are
//              rejected.
// Not checked  other alphas and degrees: the argument above speaks for them. (15) has g in C(S) for g in
// C(sigma).

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Point = Barycentric<Rational>;
using Corners = std::array<std::array<Rational, 2>, 3>;

constexpr int largest_degree = 5;

Rational monomial(const Corners& tau, const Point& x, int a, int b) {
  std::array<Rational, 2> at;
  for (std::size_t c = 0; c < 2; ++c) at[c] = x.x[0] * tau[0][c] + x.x[1] * tau[1][c] + x.x[2] * tau[2][c];
  return power(at[0], a) * power(at[1], b);
}

// At how many points of a lattice that settles equality in P_r the interpolant of x^a y^b differs from it.
Rational points_apart(const LagrangeFunctions& functions, const Corners& tau, int a, int b) {
  long count = 0;
  std::vector<Rational> values(functions.size());
  for (const Point& x : inset_nodes<Rational>(functions.degree() + 1, 0)) {
    functions.values(x, values);
    Rational sum = 0;
    for (std::size_t j = 0; j < values.size(); ++j)
      sum += monomial(tau, functions.nodes()[j], a, b) * values[j];
    if (sum != monomial(tau, x, a, b)) ++count;
  }
  return {count};
}

Rational determinant(int r, const Rational& alpha) {
  const auto functions = lagrange_functions(inset_nodes(r, alpha));
  return functions ? functions->determinant() : Rational(0);
}

}  // namespace

Finding equation_14(const Bench& bench) {
  const int degrees = bench.budget == Budget::quick ? 4 : largest_degree;
  const Corners sigma{{{0, 0}, {0, 1}, {1, 0}}};
  const Corners scalene{{{Rational(7, 3), -2}, {5, Rational(9, 4)}, {Rational(-1, 5), 8}}};
  Finding finding;
  for (int r = 0; r <= degrees; ++r)
    for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(1, 1000), Rational(333, 1000)}) {
      const std::string of = ", r = " + std::to_string(r) + ", alpha = " + alpha.to_text();
      const Rational scaled =
          r == 0 ? Rational(1) : determinant(r, 0) * power(1 - 3 * alpha, r * (r + 1) * (r + 2) / 3);
      finding.require("determinant of the nodes" + of, IsExactly{scaled}, determinant(r, alpha));
      finding.require("whether it is zero" + of, IsExactly{0}, Rational(scaled == 0 ? 1 : 0));
      const LagrangeFunctions functions = lagrange_functions(inset_nodes(r, alpha)).value();
      Rational apart = 0;
      for (int degree = 0; degree <= r; ++degree)
        for (int b = 0; b <= degree; ++b)
          apart +=
              points_apart(functions, sigma, degree - b, b) + points_apart(functions, scalene, degree - b, b);
      finding.require("points where a monomial of degree <= r is not its interpolant" + of, IsExactly{0},
                      apart);
      finding.control("points where s^(r+1) is not its interpolant" + of, IsExactly{0},
                      points_apart(functions, sigma, r + 1, 0));
    }
  std::vector<Point> doubled = inset_nodes(2, Rational(1, 10));
  doubled[1] = doubled[0];
  finding.control("whether the determinant is zero, two nodes in one place", IsExactly{0},
                  Rational(lagrange_functions(doubled) ? 0 : 1));
  return finding;
}

}  // namespace radcert::verification::m06
