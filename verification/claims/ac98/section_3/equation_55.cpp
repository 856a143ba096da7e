// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      In exact arithmetic, with the six nodes typed in as printed: at alpha = 1/6 every monomial up
//              to degree 3 is integrated exactly over the unit square, and s^4 is not. As identities in
//              alpha: the printed sum is the rule of the triangle applied to both triangles, for every
//              monomial up to degree 4.
// Not checked  nothing is left out.

#include "radcert/polynomial/nodes/inset_family.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/ac98/surfaces/planar_rule.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// The nodes (s,t) of (55), in any arithmetic.
template <class R>
std::vector<std::array<R, 2>> printed_nodes(const R& a) {
  return {{a, a}, {a, 1 - 2 * a}, {1 - 2 * a, a}, {1 - a, 1 - a}, {1 - a, 2 * a}, {2 * a, 1 - a}};
}

PlanarRule planar(const std::vector<std::array<Rational, 2>>& nodes) {
  PlanarRule rule;
  for (const auto& [s, t] : nodes) {
    rule.points.push_back({s, t});
    rule.weights.emplace_back(1, 6);
  }
  return rule;
}

std::vector<PlanarPoint> unit_square() { return {{0, 0}, {1, 0}, {1, 1}, {0, 1}}; }

// The printed sum for s^a t^b minus 1/((a + 1)(b + 1)), as a polynomial in alpha.
RationalPolynomial printed_defect(const Monomial& monomial) {
  RationalPolynomial sum;
  for (const auto& [s, t] : printed_nodes(RationalPolynomial::variable())) {
    RationalPolynomial value = 1;
    for (int k = 0; k < monomial.s; ++k) value *= s;
    for (int k = 0; k < monomial.t; ++k) value *= t;
    sum += value;
  }
  return Rational(1, 6) * sum - RationalPolynomial(Rational(1, (monomial.s + 1) * (monomial.t + 1)));
}

}  // namespace

Finding equation_55(const Bench&) {
  Finding finding;
  const InsetFamily family(1);
  const PlanarRule rule = planar(printed_nodes(Rational(1, 6)));
  for (int degree = 0; degree <= 4; ++degree)
    for (int t = 0; t <= degree; ++t) {
      const Monomial monomial{degree - t, t};
      if (degree <= 3)
        finding.require("rule minus integral, alpha = 1/6, " + monomial.to_text(), IsExactly{0},
                        missed(rule, unit_square(), monomial.s, monomial.t));
      finding.require(
          "coefficients in alpha by which the two triangles differ from the print, " + monomial.to_text(),
          IsExactly{0},
          differing_coefficients(family.defect(Region::parallelogram, monomial),
                                 {printed_defect(monomial), 0}));
    }
  finding.require("degree of precision, alpha = 1/6", IsExactly{3}, precision(rule, unit_square()));
  finding.control("rule minus integral, alpha = 1/6, s^4", IsExactly{0}, missed(rule, unit_square(), 4, 0));
  finding.control("degree of precision, alpha = 1/10", IsExactly{3},
                  precision(planar(printed_nodes(Rational(1, 10))), unit_square()));
  std::vector<std::array<Rational, 2>> misprinted = printed_nodes(Rational(1, 6));
  misprinted[4][1] = Rational(1, 6);
  finding.control(
      "degree of precision, alpha = 1/6, the node (1 - alpha, alpha) in the place of (1 - alpha, 2 alpha)",
      IsExactly{3}, precision(planar(misprinted), unit_square()));
  finding.control(
      "coefficients in alpha by which one triangle alone differs from the print, s^2", IsExactly{0},
      differing_coefficients(family.defect(Region::triangle, {2, 0}), {printed_defect({2, 0}), 0}));
  finding.show({.value = 3, .radius = 0, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::ac98
