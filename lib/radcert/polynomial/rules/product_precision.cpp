// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/product_precision.h"

#include <vector>

#include "radcert/core/contract.h"
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

template <class R>
R value(const Monomial& m, const Barycentric<R>& x) {
  const R half(Rational(1, 2));
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

// Whether `is_zero` says so of all pairs q, p of monomials about the centre whose degrees add up to `total`,
// with Int_sigma q p and the Int_sigma q l_j.
template <class IsZero>
bool for_all_pairs(const LagrangeFunctions& functions, int total, const IsZero& is_zero) {
  for (int of_q = 0; of_q <= total; ++of_q)
    for (int t = 0; t <= of_q; ++t) {
      const Monomial q{of_q - t, t};
      const std::vector<Rational> weights = moments(functions, q);
      for (int u = 0; u <= total - of_q; ++u) {
        const Monomial p{total - of_q - u, u};
        const Rational whole =
            by_powers({q.s + p.s, q.t + p.t}, [](int a, int b) { return integral(0, b, a); });
        if (!is_zero(p, whole, weights)) return false;
      }
    }
  return true;
}

// Whether Int_sigma q (p - P p) = 0 for all these pairs.
bool vanishes(const LagrangeFunctions& functions, int total) {
  return for_all_pairs(functions, total,
                       [&](const Monomial& p, Rational rest, const std::vector<Rational>& weights) {
                         for (std::size_t j = 0; j < weights.size(); ++j)
                           rest -= weights[j] * value(p, functions.nodes()[j]);
                         return rest == 0;
                       });
}

}  // namespace

int product_precision(const LagrangeFunctions& functions, Region region) {
  // Under the half turn a product of odd degree changes its sign and leaves nothing. The search ends: for p =
  // the product of the squared distances from the nodes and q = 1, P p = 0 and the integral is positive.
  int total = 0;
  while ((region == Region::parallelogram && total % 2 == 1) || vanishes(functions, total)) ++total;
  return total - 1;
}

bool products_follow(int triangle, int parallelogram) { return parallelogram <= triangle + 1; }

bool products_certainly_missed(const LagrangeFunctions& functions, std::span<const Barycentric<Ball>> nodes,
                               const Rational& change, int total) {
  expects(nodes.size() == functions.size() && change < 1, "a ball for each node, change < 1",
          named("balls", nodes.size()), named("change", change));
  return !for_all_pairs(functions, total,
                        [&](const Monomial& p, const Rational& whole, const std::vector<Rational>& near) {
                          Rational sum = 0;
                          for (const Rational& weight : near) sum += abs(weight);
                          const Ball off(sum * change / (1 - change));
                          Ball rest(whole);
                          for (std::size_t j = 0; j < near.size(); ++j)
                            rest -= widened(Ball(near[j]), off) * value(p, nodes[j]);
                          return !rest.is_finite() || rest.contains_zero();
                        });
}

}  // namespace radcert
