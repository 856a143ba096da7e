// SPDX-License-Identifier: GPL-3.0-or-later

// |D^k g| is what the bounds (30), (31) and (38) are written in. What they use of it: it vanishes identically
// for the polynomials of degree < k and no others, so that it measures what interpolation leaves over; and
// g(h x) has h^k times that of g.
//
// Checked      for every monomial of degree <= 6 and k <= 6, exactly, at a point with no zero coordinate; h =
//              1/3.
// Not checked  nothing is left of (29).

#include <algorithm>

#include "radcert/scalar/real.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

Rational falling(int n, int k) {
  Rational product = 1;
  for (int i = 0; i < k; ++i) product *= n - i;
  return product;
}

// (29) for factor x^a y^b.
Rational largest_derivative(int k, const Rational& factor, int a, int b, const Rational& x,
                            const Rational& y) {
  Rational largest = 0;
  for (int i = 0; i <= k; ++i) {
    if (i > a || k - i > b) continue;
    largest = std::max(
        largest, abs(factor * falling(a, i) * falling(b, k - i) * power(x, a - i) * power(y, b - k + i)));
  }
  return largest;
}

}  // namespace

Finding equation_29(const Bench&) {
  constexpr int largest_degree = 6;
  const Rational x(2, 3);
  const Rational y(5, 7);
  const Rational h(1, 3);
  Finding finding;
  for (int k = 1; k <= largest_degree; ++k) {
    const std::string of = ", k = " + std::to_string(k);
    Rational below = 0;
    long vanishing = 0;
    Rational scaled_wrongly = 0;
    Rational scaled_less = 0;
    for (int degree = 0; degree <= largest_degree; ++degree)
      for (int b = 0; b <= degree; ++b) {
        const int a = degree - b;
        const Rational here = largest_derivative(k, 1, a, b, x, y);
        if (degree < k) below += here;
        if (degree >= k && here == 0) ++vanishing;
        const Rational scaled = largest_derivative(k, power(h, degree), a, b, x / h, y / h);
        scaled_wrongly += abs(scaled - power(h, k) * here);
        scaled_less += abs(scaled - power(h, k - 1) * here);
      }
    finding.require("|D^k g| over the monomials of degree < k, summed" + of, IsExactly{0}, below);
    finding.require("monomials of degree k to 6 with |D^k g| = 0" + of, IsExactly{0}, Rational(vanishing));
    finding.require("|D^k g(h x)| - h^k |D^k g|, summed" + of, IsExactly{0}, scaled_wrongly);
    finding.control("|D^k g(h x)| - h^(k-1) |D^k g|, summed" + of, IsExactly{0}, scaled_less);
  }
  return finding;
}

}  // namespace radcert::verification::m06
