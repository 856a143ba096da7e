// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      In exact arithmetic, with the interpolating polynomial integrated term by term from its
//              coefficients: (52) is exact for 1, s, t whatever alpha, as identities in alpha; (53) for s^2,
//              st, t^2 at alpha = 1/6. Monomials span the polynomials of their degree, and both sides are
//              linear in f.
// Not checked  nothing is left out.

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Int L f - Int f over the triangle, for a monomial.
Rational missed(const Rational& alpha, const Monomial& monomial) {
  const std::vector<Barycentric<Rational>> nodes = InsetBasis<Rational>(1, alpha).nodes();
  return defect(interpolatory_rule(lagrange_functions(nodes).value()), Region::triangle, monomial);
}

}  // namespace

Finding equation_53(const Bench&) {
  Finding finding;
  const InsetFamily family(1);
  const auto coefficients = [&](const Monomial& monomial) {
    return differing_coefficients(family.defect(Region::triangle, monomial), {});
  };
  for (const Monomial& monomial : {Monomial{0, 0}, Monomial{1, 0}, Monomial{0, 1}})
    finding.require("coefficients in alpha of Int L f - Int f, f = " + monomial.to_text(), IsExactly{0},
                    coefficients(monomial));
  finding.control("coefficients in alpha of Int L f - Int f, f = s^2", IsExactly{0}, coefficients({2, 0}));

  const Rational sixth(1, 6);
  for (int degree = 0; degree <= 2; ++degree)
    for (int t = 0; t <= degree; ++t) {
      const Monomial monomial{degree - t, t};
      finding.require("Int L f - Int f, alpha = 1/6, f = " + monomial.to_text(), IsExactly{0},
                      missed(sixth, monomial));
    }
  finding.control("Int L f - Int f, alpha = 1/10, f = s^2", IsExactly{0}, missed(Rational(1, 10), {2, 0}));
  finding.control("Int L f - Int f, alpha = 1/6, f = s^3", IsExactly{0}, missed(sixth, {3, 0}));
  return finding;
}

}  // namespace radcert::verification::ac98
