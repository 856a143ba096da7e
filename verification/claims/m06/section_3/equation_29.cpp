// SPDX-License-Identifier: GPL-3.0-or-later

// |D^k g| is what the bounds (30), (31) and (38) are written in. What they use of it: it vanishes identically
// for the polynomials of degree < k and no others, so that it measures what interpolation leaves over; and
// Taylor's formula with it,
//   |g(x) - p_(k-1)(x)| <= sum_(i+j=k) |x^i y^j|/(i! j!) max |D^k g| = (|x| + |y|)^k/k! max |D^k g|,
// needs the mixed derivatives and has this constant.
//
// Checked      For k <= 6: the linear map from the 66 coefficients of a polynomial of degree <= 10 to the
//              coefficients of all its k-th derivatives has a kernel of the dimension k(k+1)/2 exactly, and
//              the polynomials of degree < k, so many, lie in it: there are no others. The derivatives of (x
//              + y)^k are k!, all of them. The binomial identity of Taylor's formula, as one of polynomials.
//              Rejected: the map without the mixed derivatives, for which x y is in the kernel as well, and
//              Taylor's formula without 1/(i! j!).
// Not checked  functions that are no polynomials: for them Taylor's formula has p_(k-1) for g where |D^k g| =
//              0.

#include <algorithm>
#include <vector>

#include "radcert/polynomial/plane_polynomial.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr int largest_degree = 10;
constexpr int largest_order = 6;

enum class Derivatives { all, without_mixed };

// D_x^i D_y^j of a polynomial.
PlanePolynomial<Rational> derivative(const PlanePolynomial<Rational>& g, int i, int j) {
  PlanePolynomial<Rational> result(g.degree());
  for (int a = i; a <= g.degree(); ++a)
    for (int b = j; a + b <= g.degree(); ++b) {
      Rational c = g(a, b);
      for (int n = 0; n < i; ++n) c *= a - n;
      for (int n = 0; n < j; ++n) c *= b - n;
      result(a - i, b - j) = c;
    }
  return result;
}

PlanePolynomial<Rational> monomial(int a, int b) {
  PlanePolynomial<Rational> g(largest_degree);
  g(a, b) = 1;
  return g;
}

// All coefficients of the k-th derivatives, one after the other.
std::vector<Rational> derivatives_of(const PlanePolynomial<Rational>& g, int k, Derivatives which) {
  std::vector<Rational> all;
  for (int i = 0; i <= k; ++i) {
    if (which == Derivatives::without_mixed && i != 0 && i != k) continue;
    const PlanePolynomial<Rational> part = derivative(g, i, k - i);
    all.insert(all.end(), part.coefficients().begin(), part.coefficients().end());
  }
  return all;
}

// The rank of the rows, by elimination.
long rank(std::vector<std::vector<Rational>> rows) {
  long found = 0;
  const std::size_t columns = rows.front().size();
  for (std::size_t c = 0; c < columns; ++c) {
    const auto pivot = std::find_if(rows.begin() + found, rows.end(),
                                    [c](const std::vector<Rational>& row) { return row[c] != 0; });
    if (pivot == rows.end()) continue;
    std::iter_swap(rows.begin() + found, pivot);
    const std::vector<Rational> top = rows[static_cast<std::size_t>(found)];
    ++found;
    for (auto row = rows.begin() + found; row != rows.end(); ++row) {
      if ((*row)[c] == 0) continue;
      const Rational factor = (*row)[c] / top[c];
      for (std::size_t other = c; other < columns; ++other) (*row)[other] -= factor * top[other];
    }
    if (found == static_cast<long>(rows.size())) break;
  }
  return found;
}

// The dimension of the space of polynomials of degree <= 10 with |D^k g| = 0 everywhere.
Rational dimension_of_kernel(int k, Derivatives which) {
  std::vector<std::vector<Rational>> rows;
  for (int a = 0; a <= largest_degree; ++a)
    for (int b = 0; a + b <= largest_degree; ++b) rows.push_back(derivatives_of(monomial(a, b), k, which));
  return {static_cast<long>(rows.size()) - rank(rows)};
}

// Monomials of degree < k with a k-th derivative that is not zero.
Rational outside_the_kernel(int k) {
  long count = 0;
  for (int a = 0; a < k; ++a)
    for (int b = 0; a + b < k; ++b) {
      const std::vector<Rational> all = derivatives_of(monomial(a, b), k, Derivatives::all);
      if (std::any_of(all.begin(), all.end(), [](const Rational& c) { return c != 0; })) ++count;
    }
  return {count};
}

Rational factorial(int n) {
  Rational product = 1;
  for (int i = 2; i <= n; ++i) product *= i;
  return product;
}

// How many k-th derivatives of (x + y)^power are not k!, at the origin.
Rational derivatives_off(int k, int power) {
  PlanePolynomial<Rational> g(largest_degree);
  for (int i = 0; i <= power; ++i) g(i, power - i) = factorial(power) / (factorial(i) * factorial(power - i));
  long count = 0;
  for (int i = 0; i <= k; ++i)
    if (derivative(g, i, k - i)(0, 0) != factorial(k)) ++count;
  return {count};
}

// (x + y)^k/k! less sum x^i y^j/(i! j!), or less sum x^i y^j/k!.
Rational terms_of_taylor(int k, bool with_factorials) {
  const Polynomial x = Polynomial::variable("x");
  const Polynomial y = Polynomial::variable("y");
  const auto to_the = [](const Polynomial& base, int n) {
    Polynomial result = 1;
    for (int i = 0; i < n; ++i) result = result * base;
    return result;
  };
  Polynomial rest = Polynomial(1 / factorial(k)) * to_the(x + y, k);
  for (int i = 0; i <= k; ++i)
    rest = rest + Polynomial(-1 / (with_factorials ? factorial(i) * factorial(k - i) : factorial(k))) *
                      to_the(x, i) * to_the(y, k - i);
  return differing_terms(rest, 0);
}

}  // namespace

Finding equation_29(const Bench&) {
  Finding finding;
  for (int k = 1; k <= largest_order; ++k) {
    const std::string of = ", k = " + std::to_string(k);
    const IsExactly dimension{Rational(k * (k + 1), 2)};
    finding.require("monomials of degree < k with |D^k g| != 0" + of, IsExactly{0}, outside_the_kernel(k));
    finding.require("dimension of the polynomials of degree <= 10 with |D^k g| = 0" + of, dimension,
                    dimension_of_kernel(k, Derivatives::all));
    finding.require("k-th derivatives of (x + y)^k that are not k!" + of, IsExactly{0},
                    derivatives_off(k, k));
    finding.control("k-th derivatives of (x + y)^(k+1) that are not k!, at the origin" + of, IsExactly{0},
                    derivatives_off(k, k + 1));
    finding.require("terms of (x + y)^k/k! less sum x^i y^j/(i! j!)" + of, IsExactly{0},
                    terms_of_taylor(k, true));
    if (k == 1) continue;
    finding.control("dimension of those with D_x^k g = D_y^k g = 0, the mixed left out" + of, dimension,
                    dimension_of_kernel(k, Derivatives::without_mixed));
    finding.control("terms of (x + y)^k/k! less sum x^i y^j/k!" + of, IsExactly{0},
                    terms_of_taylor(k, false));
  }
  return finding;
}

}  // namespace radcert::verification::m06
