// SPDX-License-Identifier: GPL-3.0-or-later

// The norm of P_n is the largest value of the Lebesgue function sum |l_i| on the reference triangle: P_n acts
// on each element by itself, and data of absolute value 1 reach that largest value.
//
// Checked      For every alpha of 0 < alpha < 1/3 at once, as identities of polynomials in alpha: the
//              numerators of (1 - 3 alpha) l_i at the vertices are 1 - alpha at its own and -alpha at the
//              others, neither has a zero in 0 < alpha <= 1/3 (Sturm), so that their absolute values sum to 1
//              + alpha. The Lebesgue function is convex, as each l_i is affine, so no other point exceeds the
//              vertices. Beside that, at four alphas, the library's own basis: the vertices, and a lattice of
//              points none of which exceeds them.
// Not checked  that P_n extends to L^infinity with the same norm.

#include <algorithm>
#include <array>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/real_zeros.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Point = Barycentric<Rational>;

Rational lebesgue(const InsetBasis<Rational>& basis, const Point& x) {
  std::array<Rational, 3> values;
  basis.values(x, std::span<Rational>(values));
  Rational sum = 0;
  for (const Rational& value : values) sum += abs(value);
  return sum;
}

std::array<Point, 3> vertices() { return {Point{{1, 0, 0}}, Point{{0, 1, 0}}, Point{{0, 0, 1}}}; }

Rational norm_at_vertices(const Rational& alpha) {
  const InsetBasis<Rational> basis(1, alpha);
  Rational largest = 0;
  for (const Point& vertex : vertices()) largest = std::max(largest, lebesgue(basis, vertex));
  return largest;
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

void require_for_every_alpha(Finding& finding) {
  const RationalPolynomial alpha = RationalPolynomial::variable();
  const InsetFamily family(1);
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    RationalPolynomial sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const InsetFunction l = family.value(i, vertices()[vertex]);
      const std::string title = "l_" + std::to_string(i + 1) + " at vertex " + std::to_string(vertex + 1);
      const bool own = i == vertex;
      finding.require(
          title + ": coefficients of (1 - 3 alpha) l that are not those of " + (own ? "1 - alpha" : "-alpha"),
          IsExactly{0}, differing_coefficients(l, {own ? 1 - alpha : -alpha, 1}));
      finding.require(title + ": zeros in 0 < alpha <= 1/3", IsExactly{0},
                      Rational(zeros_between(l.numerator, 0, Rational(1, 3))));
      sum += l.numerator(Rational(1, 6)).sign() < 0 ? -l.numerator : l.numerator;
    }
    finding.require("vertex " + std::to_string(vertex + 1) +
                        ": coefficients of (1 - 3 alpha) sum |l_i| that are not those of 1 + alpha",
                    IsExactly{0}, differing_coefficients({sum, 1}, {1 + alpha, 1}));
  }
  const InsetFunction norm = linear_lebesgue_constant();
  finding.require("coefficients of the norm that are not those of (1 + alpha)/(1 - 3 alpha)", IsExactly{0},
                  differing_coefficients(norm, {1 + alpha, 1}));
  finding.control("coefficients of the norm that are not those of (1 + 2 alpha)/(1 - 3 alpha)", IsExactly{0},
                  differing_coefficients(norm, {1 + 2 * alpha, 1}));
}

}  // namespace

Finding equation_37(const Bench& bench) {
  const long parts = bench.budget == Budget::quick ? 24 : bench.budget == Budget::standard ? 96 : 192;
  Finding finding;
  require_for_every_alpha(finding);
  for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(1, 1000), Rational(333, 1000)}) {
    const std::string at = ", alpha = " + alpha.to_text();
    finding.require("largest value of sum |l_i| over the vertices" + at,
                    IsExactly{(1 + alpha) / (1 - 3 * alpha)}, norm_at_vertices(alpha));
    finding.require("lattice points where sum |l_i| is larger" + at, IsExactly{0},
                    Rational(points_above_the_vertices(alpha, parts)));
  }
  finding.require("the norm that the paper prints for alpha = 1/6", IsExactly{Rational(7, 3)},
                  norm_at_vertices(Rational(1, 6)));
  finding.require("the norm that the paper prints for alpha = 0", IsExactly{1}, norm_at_vertices(0));
  const Rational tenth(1, 10);
  finding.control("the norm for nodes with alpha = 1/7, against (37) for alpha = 1/10",
                  IsExactly{(1 + tenth) / (1 - 3 * tenth)}, norm_at_vertices(Rational(1, 7)));
  finding.show(proved(Ball(norm_at_vertices(Rational(1, 6)))));
  return finding;
}

}  // namespace radcert::verification::ac98
