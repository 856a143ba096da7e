// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/rules/conical_rule.h"

namespace radcert {

/// The integration rule that integrates the interpolating polynomial.
/// Maths     Int_sigma f ~ sum_j w_j f(q_j), w_j = Int_sigma l_j = 1/((r + 1)(r + 2)) sum_k c_kj: every
///           Bernstein polynomial of degree r has the same integral
/// Source    [m06, (16)]; r = 1: [ac98, (54)]
/// Result    exact; points and weights in the order of the nodes, weights with the sum 1/2
/// Limits    weights may be negative or zero
[[nodiscard]] TriangleRule<Rational> interpolatory_rule(const LagrangeFunctions& functions);

}  // namespace radcert
