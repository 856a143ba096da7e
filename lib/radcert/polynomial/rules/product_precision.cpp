// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/product_precision.h"

#include <vector>

#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

Rational factorial(int n) {
  Rational product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

// Int_sigma x_1^k1 x_2^k2 x_3^k3.
Rational integral(int k1, int k2, int k3) {
  return factorial(k1) * factorial(k2) * factorial(k3) / factorial(k1 + k2 + k3 + 2);
}

Rational binomial(int n, int k) { return factorial(n) / (factorial(k) * factorial(n - k)); }

// sum over x_3^a x_2^b of (s - 1/2)^m.s (t - 1/2)^m.t, the coordinates about the centre of the parallelogram.
template <class Term>
Rational by_powers(const Monomial& m, const Term& term) {
  const Rational minus_half(-1, 2);
  Rational sum = 0;
  for (int a = 0; a <= m.s; ++a)
    for (int b = 0; b <= m.t; ++b)
      sum += binomial(m.s, a) * binomial(m.t, b) * power(minus_half, m.s - a + m.t - b) * term(a, b);
  return sum;
}

Rational value(const Monomial& m, const Barycentric<Rational>& x) {
  const Rational half(1, 2);
  return power(x.x[2] - half, m.s) * power(x.x[1] - half, m.t);
}

// Int_sigma q l_j for all j.
std::vector<Rational> moments(const LagrangeFunctions& functions, const Monomial& q) {
  const int r = functions.degree();
  std::vector<Rational> of_bernstein;
  for (const auto& [k1, k2, k3] : lattice_indices(r)) {
    const Rational terms = factorial(r) / (factorial(k1) * factorial(k2) * factorial(k3));
    of_bernstein.push_back(terms * by_powers(q, [&, k1 = k1, k2 = k2, k3 = k3](int a, int b) {
                             return integral(k1, k2 + b, k3 + a);
                           }));
  }
  std::vector<Rational> out;
  for (std::size_t j = 0; j < functions.size(); ++j) {
    const std::span<const Rational> c = functions.bernstein_coefficients(j);
    Rational sum = 0;
    for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * of_bernstein[k];
    out.push_back(sum);
  }
  return out;
}

// Whether Int_sigma q (p - P p) = 0 for all pairs of monomials about the centre whose degrees add up to
// `total`.
bool vanishes(const LagrangeFunctions& functions, int total) {
  for (int of_q = 0; of_q <= total; ++of_q)
    for (int t = 0; t <= of_q; ++t) {
      const Monomial q{of_q - t, t};
      const std::vector<Rational> weights = moments(functions, q);
      for (int u = 0; u <= total - of_q; ++u) {
        const Monomial p{total - of_q - u, u};
        Rational rest = by_powers({q.s + p.s, q.t + p.t}, [](int a, int b) { return integral(0, b, a); });
        for (std::size_t j = 0; j < weights.size(); ++j) rest -= weights[j] * value(p, functions.nodes()[j]);
        if (rest != 0) return false;
      }
    }
  return true;
}

}  // namespace

int product_precision(const LagrangeFunctions& functions, Region region) {
  // Under the half turn a product of odd degree changes its sign and leaves nothing. The search ends: for p =
  // the product of the squared distances from the nodes and q = 1, P p = 0 and the integral is positive.
  int total = 0;
  while ((region == Region::parallelogram && total % 2 == 1) || vanishes(functions, total)) ++total;
  return total - 1;
}

}  // namespace radcert
