// SPDX-License-Identifier: GPL-3.0-or-later

// With y = (x - alpha)/(1 - 3 alpha) in each barycentric coordinate the nodes (13) are y = k/r, those of the
// lattice, alpha = 0: l_k(x) = L_k(y). L_k(m/r) = delta_km for the lattice gives l_k(q_m) = delta_km for
// every alpha but 1/3. So the f_r functions l_k are independent and span P_r, which has that dimension: one
// polynomial of degree r interpolates, and no other. On a triangle tau the affine m_tau takes P_r to P_r. The
// determinant of the nodes is that of the lattice times (1 - 3 alpha)^(r (r + 1)(r + 2)/3), as the scaling
// has the eigenvalue (1 - 3 alpha)^k on the k + 1 polynomials of degree k.
//
// Checked      l_k(q_m) = delta_km for every r >= 1 and every alpha: lattice_functions.h. The library's
//              L_k(m/r) = delta_km, exactly, r = 0 to 8; l_k(x) = L_k(y) as identities in alpha, L_k by
//              inverting a matrix and l_k by the library's product, at as many points as settle an equality
//              in P_r, r = 0 to 4. For r = 0 to 4 (5 beyond quick) and four alphas besides: the determinant;
//              sum g(q_j) l_j = g for every monomial g of degree <= r on the reference triangle and on a
//              scalene one, (27); not for s^(r+1). Rejected: the functions of the lattice at other nodes;
//              two nodes in one place.
// Not checked  that P_r has the dimension f_r. (15) has g in C(S) for g in C(sigma).

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/m06/section_2/lattice_functions.h"
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

// Pairs k, m with L_k(q_m) other than delta_km, q_m the nodes of an inset and L_k the functions of the
// lattice.
Rational pairs_off(int r, const Rational& inset) {
  const InsetBasis<Rational> lattice(r, 0);
  std::vector<Rational> values(lattice.size());
  const std::vector<Point> nodes = inset_nodes<Rational>(r, inset);
  long count = 0;
  for (std::size_t m = 0; m < nodes.size(); ++m) {
    lattice.values(nodes[m], std::span<Rational>(values));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k] != Rational(k == m ? 1 : 0)) ++count;
  }
  return {count};
}

// L_k((x - shift alpha)/(1 - 3 alpha)) by its Bernstein coefficients: sum c_i r!/(i_1! i_2! i_3!) prod (x -
// shift alpha)^i over (1 - 3 alpha)^r.
InsetFunction scaled_value(const LagrangeFunctions& lattice, std::size_t k, const Point& x, int shift) {
  const RationalPolynomial alpha = RationalPolynomial::variable();
  const std::vector<std::array<int, 3>> indices = lattice_indices(lattice.degree());
  InsetFunction value{.numerator = 0, .pole_order = lattice.degree()};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    RationalPolynomial term = lattice.bernstein_coefficients(k)[i];
    int above = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (int m = 1; m <= indices[i][c]; ++m) term *= Rational(++above, m) * (x.x[c] - shift * alpha);
    value.numerator += term;
  }
  return value;
}

// Coefficients in alpha of l_k(x) - L_k(y), over all k and the points of the lattice of degree r + 1.
Rational coefficients_apart(int r, int shift) {
  const LagrangeFunctions lattice = lagrange_functions(inset_nodes<Rational>(r, 0)).value();
  const InsetFamily family(r);
  Rational count = 0;
  for (const Point& x : inset_nodes<Rational>(r + 1, 0))
    for (std::size_t k = 0; k < family.size(); ++k)
      count += ac98::differing_coefficients(family.value(k, x), scaled_value(lattice, k, x, shift));
  return count;
}

}  // namespace

Finding equation_14(const Bench& bench) {
  const int degrees = bench.budget == Budget::quick ? 4 : largest_degree;
  const Corners sigma{{{0, 0}, {0, 1}, {1, 0}}};
  const Corners scalene{{{Rational(7, 3), -2}, {5, Rational(9, 4)}, {Rational(-1, 5), 8}}};
  Finding finding;
  require_delta_at_the_nodes(finding);
  const IsExactly none{0};
  for (int r = 0; r <= 8; ++r) {
    const std::string of = ", r = " + std::to_string(r);
    finding.require("pairs k, m with L_k(m/r) other than delta" + of, none, pairs_off(r, 0));
    if (r > 0)
      finding.control("pairs with L_k(q_m) other than delta, q_m the nodes for alpha = 1/20" + of, none,
                      pairs_off(r, Rational(1, 20)));
  }
  for (int r = 0; r <= 4; ++r) {
    const std::string of = ", r = " + std::to_string(r);
    finding.require("coefficients in alpha of l_k(x) - L_k((x - alpha)/(1 - 3 alpha))" + of, none,
                    coefficients_apart(r, 1));
    if (r > 0)
      finding.control("coefficients in alpha of l_k(x) - L_k((x - 2 alpha)/(1 - 3 alpha))" + of, none,
                      coefficients_apart(r, 2));
  }
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
