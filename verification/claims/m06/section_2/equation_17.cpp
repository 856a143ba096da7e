// SPDX-License-Identifier: GPL-3.0-or-later

// P_n works element by element through the same l_j, so that its norm on the bounded functions is max sum
// |l_j| over sigma, whatever n is; and P_n P_n = P_n as l_i(q_j) = delta_ij, (14), for every alpha. With y =
// (x - alpha)/(1 - 3 alpha) each of the r factors of l_k = prod (r y_i - a)/(k_i - a) is at most 2r/(1 - 3
// alpha): |y_i| <= 1/(1 - 3 alpha), a < r. So the norm is at most f_r (2r/(1 - 3 alpha))^r, for every alpha.
//
// Checked      P_n is a projection, l_i(q_j) = delta_ij, and the bound of its norm, for every r >= 1 and
//              every alpha: lattice_functions.h. The library's l_i at alpha = 1/10, exactly, r = 1 to 5. The
//              norm: (1 + alpha)/(1 - 3 alpha) for r = 1, as an identity in alpha and at three alphas; for r
//              = 2 to 5 at alpha = 1/10 enclosed by Bernstein bounds, and equal to sum |l_j| at a corner of
//              sigma to the width of the enclosure, and below the bound. Rejected: the l_j at other nodes;
//              alpha = 0, where the corner is not the place of the maximum; alpha near 1/3 against the bound
//              for 1/10.
// Not checked  that the corner is the place of the maximum for other alphas and r.

#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/m06/section_2/lattice_functions.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

LagrangeFunctions functions_at(int r, const Rational& alpha) {
  return lagrange_functions(inset_nodes(r, alpha)).value();
}

Rational at_a_corner(const LagrangeFunctions& functions) {
  std::vector<Rational> values(functions.size());
  functions.values({{1, 0, 0}}, values);
  Rational sum = 0;
  for (const Rational& value : values) sum += abs(value);
  return sum;
}

// Pairs i, j with l_i(q_j) other than it should be.
Rational pairs_off(const LagrangeFunctions& functions, const std::vector<Barycentric<Rational>>& nodes) {
  long count = 0;
  std::vector<Rational> values(functions.size());
  for (std::size_t j = 0; j < functions.size(); ++j) {
    functions.values(nodes[j], values);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != Rational(i == j ? 1 : 0)) ++count;
  }
  return {count};
}

Ball norm(const LagrangeFunctions& functions, const Rational& tolerance) {
  const LebesgueConstant constant = lebesgue_constant(functions, tolerance);
  return hull(Ball(constant.lower), Ball(constant.upper));
}

// f_r (2r/(1 - 3 alpha))^r.
Rational bound(int r, const Rational& alpha) {
  return Rational((r + 1) * (r + 2) / 2) * power(2 * r / (1 - 3 * alpha), r);
}

}  // namespace

Finding equation_17(const Bench& bench) {
  const Rational tolerance(1, bench.budget == Budget::quick ? 1000 : 1000000);
  const double within = 2 * tolerance.to_double();
  const BallPrecision precision(128);
  Finding finding;
  require_delta_at_the_nodes(finding);
  require_bound_of_the_functions(finding);
  const RationalPolynomial a = RationalPolynomial::variable();
  finding.require("r = 1: coefficients of the norm that are not those of (1 + alpha)/(1 - 3 alpha)",
                  IsExactly{0}, ac98::differing_coefficients(linear_lebesgue_constant(), {1 + a, 1}));
  for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(1, 100)}) {
    const AgreesWith formula{.value = Ball((1 + alpha) / (1 - 3 * alpha)), .within = within};
    finding.require("norm of P_n, r = 1, alpha = " + alpha.to_text(), formula,
                    norm(functions_at(1, alpha), tolerance));
    finding.control("norm of P_n, r = 1, alpha + 1/20 in the place of alpha = " + alpha.to_text(), formula,
                    norm(functions_at(1, alpha + Rational(1, 20)), tolerance));
  }
  const Rational tenth(1, 10);
  constexpr int largest_degree = 5;
  for (int r = 1; r <= largest_degree; ++r) {
    const std::string of = ", alpha = 1/10, r = " + std::to_string(r);
    const LagrangeFunctions functions = functions_at(r, tenth);
    finding.require("pairs i, j with a wrong l_i(q_j)" + of, IsExactly{0},
                    pairs_off(functions, functions.nodes()));
    finding.control("the same for the nodes of alpha + 1/20" + of, IsExactly{0},
                    pairs_off(functions, inset_nodes<Rational>(r, tenth + Rational(1, 20))));
    const Ball enclosed = norm(functions, tolerance);
    finding.require("norm of P_n against sum |l_j| at a corner" + of,
                    AgreesWith{.value = Ball(at_a_corner(functions)), .within = within}, enclosed);
    const AtMost not_above{};
    finding.require("norm of P_n less f_r (2r/(1 - 3 alpha))^r" + of, not_above,
                    proved(enclosed - Ball(bound(r, tenth))));
    finding.control("norm of P_n for alpha = 33333/100000 less that bound" + of, not_above,
                    proved(norm(functions_at(r, Rational(33333, 100000)), 1) - Ball(bound(r, tenth))));
    if (r > 1) {
      const LagrangeFunctions on_border = functions_at(r, 0);
      finding.control("norm of P_n against sum |l_j| at a corner, alpha = 0, r = " + std::to_string(r),
                      AgreesWith{.value = Ball(at_a_corner(on_border)), .within = within},
                      norm(on_border, tolerance));
    }
    finding.remark("norm of P_n" + of, proved(enclosed));
  }
  return finding;
}

}  // namespace radcert::verification::m06
