// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/enclosure/square_function.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// A Gauss rule for one variable of a cell, and what it misses.
struct RuleInOneVariable {
  int nodes = 0;
  Ball error;  ///< at least |Int_-1^1 f - Q f| for each value of the other variable, x and y taken to [-1,1]
};

/// The same for |f| <= bound where the variable is in the ellipse E_rho of gauss_error_factor and the other
/// one real.
[[nodiscard]] RuleInOneVariable rule_for_ellipse(int nodes, double rho, double bound);

/// The integral of a function over a cell by a product of Gauss rules.
/// Maths     |Int Int f - Q_x Q_y f| <= 2 h_x h_y (e_x + e_y), 2 h the sides: Int_x (Int_y - Q_y) f is at
///           most 2 e_y, Q_y (Int_x - Q_x) f at most 2 e_x, as the weights of either rule are positive with
///           the sum 2
/// Requires  nodes >= 1
/// Result    value: the integral, enclosed, its radius with the error and all roundings; error: what the
///           rules miss. nodes_x nodes_y evaluations in balls
struct ProductRuleValue {
  Ball value;
  Ball error;
};
[[nodiscard]] ProductRuleValue by_product_rule(const SquareFunction& f, const SquareCell& cell,
                                               const RuleInOneVariable& in_x, const RuleInOneVariable& in_y);

}  // namespace radcert
