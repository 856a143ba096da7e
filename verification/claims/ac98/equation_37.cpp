// SPDX-License-Identifier: GPL-3.0-or-later

// The norm of P_n is the largest value of the Lebesgue function sum |l_i| on the reference triangle: P_n acts on each element by itself,
// and data of absolute value 1 reach that largest value.
//
// Checked      In exact arithmetic, from the library's own basis of degree 1: (1 - 3 alpha) l_i at the vertices is x_i - alpha at four
//              alphas. Both sides are affine in x and, on 0 < alpha < 1/3, in alpha, so two alphas and three vertices would do. Then
//              1 - alpha > 0 > -alpha gives (1 - 3 alpha) sum |l_i| = 1 + alpha at each vertex, checked at each alpha as well. The
//              Lebesgue function is convex, so no other point exceeds the vertices; a lattice of points is evaluated all the same.
// Not checked  that P_n extends to L^infinity with the same norm.

#include <array>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "verification/claims/ac98/checks.h"

namespace radcert::verification::ac98 {
namespace {

using Point = Barycentric<Rational>;

std::array<Rational, 3> basis_values(const InsetBasis<Rational>& basis, const Point& x) {
  std::array<Rational, 3> values;
  basis.values(x, values);
  return values;
}

Rational lebesgue(const InsetBasis<Rational>& basis, const Point& x) {
  Rational sum = 0;
  for (const Rational& value : basis_values(basis, x)) sum += abs(value);
  return sum;
}

std::array<Point, 3> vertices() { return {Point{{1, 0, 0}}, Point{{0, 1, 0}}, Point{{0, 0, 1}}}; }

Rational norm_at_vertices(const Rational& alpha) {
  const InsetBasis<Rational> basis(1, alpha);
  Rational largest = 0;
  for (const Point& vertex : vertices()) largest = std::max(largest, lebesgue(basis, vertex));
  return largest;
}

// How often (1 - 3 alpha) l_i = x_i - alpha fails over the vertices.
long numerators_that_differ(const Rational& alpha) {
  const InsetBasis<Rational> basis(1, alpha);
  long count = 0;
  for (const Point& vertex : vertices()) {
    const std::array<Rational, 3> values = basis_values(basis, vertex);
    for (std::size_t i = 0; i < 3; ++i)
      if ((1 - 3 * alpha) * values[i] != vertex.x[i] - alpha) ++count;
  }
  return count;
}

// How many points of a lattice exceed the vertices.
long points_above_the_vertices(const Rational& alpha, long parts) {
  const InsetBasis<Rational> basis(1, alpha);
  const Rational norm = norm_at_vertices(alpha);
  long count = 0;
  for (long i = 0; i <= parts; ++i)
    for (long j = 0; i + j <= parts; ++j)
      if (lebesgue(basis, {{Rational(i, parts), Rational(j, parts), Rational(parts - i - j, parts)}}) > norm)
        ++count;
  return count;
}

}  // namespace

Finding equation_37(const Bench& bench) {
  const long parts = bench.budget == Budget::quick ? 24 : bench.budget == Budget::standard ? 96 : 192;
  Finding finding;
  for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(1, 1000), Rational(333, 1000)}) {
    const std::string at = ", alpha = " + alpha.to_text();
    finding.require("coefficients of (1 - 3 alpha) l_i that are not those of x_i - alpha" + at, IsExactly{0},
                    Rational(numerators_that_differ(alpha)));
    finding.require("largest value of sum |l_i| over the vertices" + at,
                    IsExactly{(1 + alpha) / (1 - 3 * alpha)}, norm_at_vertices(alpha));
    finding.require("lattice points where sum |l_i| is larger" + at, IsExactly{0},
                    Rational(points_above_the_vertices(alpha, parts)));
  }
  finding.require("the norm that the paper prints for alpha = 1/6", IsExactly{Rational(7, 3)},
                  norm_at_vertices(Rational(1, 6)));
  const Rational tenth(1, 10);
  finding.control("(1 + alpha)/(1 - 2 alpha) in its place, alpha = 1/10",
                  IsExactly{(1 + tenth) / (1 - 2 * tenth)}, norm_at_vertices(tenth));
  finding.show(
      {.value = norm_at_vertices(Rational(1, 6)).to_double(), .radius = 0x1p-51, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::ac98
