// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/quadrature/certified/element_functions.h"

namespace radcert {

/// Lagrange functions as functions on elements.
/// Maths     l_j by Bernstein polynomials: sum_k c_jk multinomial(k) x_1^k_1 x_2^k_2 x_3^k_3. With
///           multinomials for weights the |x_1|^k_1 |x_2|^k_2 |x_3|^k_3 have the sum (|x_1| + |x_2| +
///           |x_3|)^r, so that |l_j| <= max |c_jk| (|x_1| + |x_2| + |x_3|)^r, for complex x too
/// Requires  functions of degree at most 8, which outlive it
/// Result    as ElementFunctions has it; the bound is attained where all c_jk of one j are of one size and
///           have the signs of their monomials
class LagrangeOnElements final : public ElementFunctions {
public:
  explicit LagrangeOnElements(const LagrangeFunctions& functions);
  [[nodiscard]] std::size_t size() const override { return functions_.size(); }
  void values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const override;
  [[nodiscard]] double bound(const ElementPoint<TaylorModel>& at) const override;

private:
  const LagrangeFunctions& functions_;
  std::vector<std::array<int, 3>> indices_;
  std::vector<BoundedDouble> coefficients_;  ///< of the monomials, for each j in turn
  double largest_ = 0;                       ///< at least max |c_jk|
};

}  // namespace radcert
