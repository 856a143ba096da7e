// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/interpolatory_rule.h"

namespace radcert {

TriangleRule<Rational> interpolatory_rule(const LagrangeFunctions& functions) {
  const long r = functions.degree();
  TriangleRule<Rational> rule;
  rule.points = functions.nodes();
  for (std::size_t j = 0; j < functions.size(); ++j) {
    Rational sum = 0;
    for (const Rational& coefficient : functions.bernstein_coefficients(j)) sum += coefficient;
    rule.weights.push_back(sum / ((r + 1) * (r + 2)));
  }
  return rule;
}

}  // namespace radcert
