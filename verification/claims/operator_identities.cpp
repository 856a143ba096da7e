// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/operator_identities.h"

#include "verification/claims/operator_algebra.h"

namespace radcert::verification {
namespace {

const Operator one(1);

Operator t() { return Operator("K"); }
Operator sum() { return Operator("Z"); }    // S_k
Operator power() { return Operator("Y"); }  // T^(k+1)

// What k gives; Y Z = Z Y follows from it, as Y = I + K Z - Z and K Z = Z K.
OperatorRelations at_k() {
  return OperatorRelations({{.product = "KZ", .replacement = sum() + power() - one},
                            {.product = "ZK", .replacement = sum() + power() - one},
                            {.product = "YK", .replacement = t() * power()},
                            {.product = "YZ", .replacement = sum() * power()}});
}
// Z and Y any operators.
OperatorRelations without_induction() { return OperatorRelations({}); }

// Words in which the three equations fail for a sum and a power, from both sides.
Rational not_telescoping(const OperatorRelations& relations, const Operator& of_sum,
                         const Operator& of_power) {
  return relations.differing_words((one - t()) * of_sum, one - of_power) +
         relations.differing_words(of_sum * (one - t()), one - of_power) +
         relations.differing_words(of_power * t(), t() * of_power);
}

}  // namespace

void require_neumann_series(Finding& finding) {
  finding.require("words of (I - T) S_k - (I - T^(k+1)), k = 0", IsExactly{0},
                  not_telescoping(without_induction(), one, t()));
  finding.require("words of the same for k + 1, by what k gives", IsExactly{0},
                  not_telescoping(at_k(), sum() + power(), t() * power()));
  finding.control("words of the same for k + 1, the sum without the power k + 1", IsExactly{0},
                  not_telescoping(at_k(), sum(), t() * power()));
  finding.control("words of the same for k + 1, without what k gives", IsExactly{0},
                  not_telescoping(without_induction(), sum() + power(), t() * power()));
}

void require_steps_of_neumann_series(Finding& finding) {
  finding.require("words of I + T 0 - S_0", IsExactly{0},
                  without_induction().differing_words(one + t() * Operator(0), one));
  finding.require("words of I + T S_k - S_(k+1)", IsExactly{0},
                  at_k().differing_words(one + t() * sum(), sum() + power()));
  finding.control("words of T (I + S_k) - S_(k+1)", IsExactly{0},
                  at_k().differing_words(t() * (one + sum()), sum() + power()));
}

void require_error_by_inverse(Finding& finding) {
  const Operator k("K");
  const Operator p("P");
  const Operator y("Y");
  const OperatorRelations inverse({{.product = "PKY", .replacement = y - one},  //
                                   {.product = "YPK", .replacement = y - one}});
  const Operator u_n = y * p * (one - k);  // of u
  const Operator before = (one - p * k) * (one - u_n);
  finding.require("words of (I - P K)(u - u_n) - (u - P u)", IsExactly{0},
                  inverse.differing_words(before, one - p));
  finding.require("words of u - u_n - (I - P K)^-1 (u - P u)", IsExactly{0},
                  inverse.differing_words(one - u_n, y * (one - p)));
  finding.control("words of the first for u_n = W P E with any W", IsExactly{0},
                  without_induction().differing_words(before, one - p));
  finding.control("words of u - u_n - (u - P u)", IsExactly{0}, inverse.differing_words(one - u_n, one - p));
  finding.control("words of u - u_n - (I - P K)^-1 K(u - P u)", IsExactly{0},
                  inverse.differing_words(one - u_n, y * k * (one - p)));
}

}  // namespace radcert::verification
