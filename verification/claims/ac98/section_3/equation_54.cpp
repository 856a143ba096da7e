// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      As identities in alpha: the integrals of l_1, l_2, l_3 are 1/6 each and the nodes are those
//              printed; constants and linear functions are integrated exactly. The insets of [0, 1/3) that
//              are exact of degree 2 as well are the common zeros of three polynomials in alpha, counted by
//              Sturm's theorem: there is one, and it is 1/6. So the degree of precision is 1 for every other
//              alpha. At 1/6 it is 2 and no more, for the rule typed in as printed.
// Not checked  nothing is left out.

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/real_zeros.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// (54), typed in: the points are (s,t).
TriangleRule<Rational> printed(const Rational& alpha) {
  const auto at = [](const Rational& s, const Rational& t) {
    return Barycentric<Rational>{{1 - s - t, t, s}};
  };
  const Rational far = 1 - 2 * alpha;
  return {.points = {at(alpha, alpha), at(alpha, far), at(far, alpha)},
          .weights = std::vector<Rational>(3, Rational(1, 6))};
}

// How many alpha of [0, 1/3) are exact of a degree; the polynomial has no zero at 1/3.
Rational insets_exact_of(int degree, const InsetFamily& family) {
  const RationalPolynomial condition = family.condition(Region::triangle, degree);
  const int at_zero = condition(0) == 0 ? 1 : 0;
  const int at_a_third = condition(Rational(1, 3)) == 0 ? 1 : 0;
  return at_zero + zeros_between(condition, 0, Rational(1, 3)) - at_a_third;
}

Rational precision(const Rational& alpha) {
  return degree_of_precision(printed(alpha), Region::triangle).degree;
}

}  // namespace

Finding equation_54(const Bench&) {
  Finding finding;
  const RationalPolynomial alpha = RationalPolynomial::variable();
  const InsetFamily family(1);
  const std::vector<std::array<RationalPolynomial, 2>> nodes{
      {alpha, alpha}, {alpha, 1 - 2 * alpha}, {1 - 2 * alpha, alpha}};
  for (std::size_t j = 0; j < 3; ++j) {
    const std::string name = std::to_string(j + 1);
    finding.require("coefficients in alpha of Int l_" + name + " - 1/6", IsExactly{0},
                    differing_coefficients(family.weight(j), {Rational(1, 6), 0}));
    finding.require("coefficients in alpha of node " + name + " minus the printed one, s", IsExactly{0},
                    differing_coefficients({family.node(j)[2], 0}, {nodes[j][0], 0}));
    finding.require("coefficients in alpha of node " + name + " minus the printed one, t", IsExactly{0},
                    differing_coefficients({family.node(j)[1], 0}, {nodes[j][1], 0}));
  }
  finding.control("coefficients in alpha of Int l_1 - 1/3", IsExactly{0},
                  differing_coefficients(family.weight(0), {Rational(1, 3), 0}));
  for (int degree = 0; degree <= 1; ++degree)
    finding.require("coefficients in alpha of the defects of degree " + std::to_string(degree), IsExactly{0},
                    differing_coefficients({family.condition(Region::triangle, degree), 0}, {}));
  finding.require("insets of [0, 1/3) that are exact of degree 2", IsExactly{1}, insets_exact_of(2, family));
  finding.control("insets of [0, 1/3) that are exact of degree 3", IsExactly{1}, insets_exact_of(3, family));
  finding.require("condition for degree 2, at alpha = 1/6", IsExactly{0},
                  family.condition(Region::triangle, 2)(Rational(1, 6)));
  finding.require("degree of precision, alpha = 1/6", IsExactly{2}, precision(Rational(1, 6)));
  finding.require("degree of precision, alpha = 1/10", IsExactly{1}, precision(Rational(1, 10)));
  finding.require("degree of precision, alpha = 0", IsExactly{1}, precision(0));
  finding.control("degree of precision, alpha = 1/7", IsExactly{2}, precision(Rational(1, 7)));
  finding.show({.value = 2, .radius = 0, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::ac98
