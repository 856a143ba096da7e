// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "radcert/polynomial/barycentric.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/polynomial/rules/degree_of_precision.h"

namespace radcert {

/// A rational function of the inset whose only pole is 1/3.
/// Maths     N(alpha) / (1 - 3 alpha)^p
/// Requires  operator(): alpha != 1/3 if p > 0, else ContractViolation
/// Result    in lowest terms where InsetFamily made it: N(1/3) != 0 or p = 0
struct InsetFunction {
  RationalPolynomial numerator;
  int pole_order = 0;
  [[nodiscard]] Rational operator()(const Rational& alpha) const;
  /// "(alpha + 1) / (1 - 3 alpha)^2".
  [[nodiscard]] std::string to_text() const;
  friend bool operator==(const InsetFunction&, const InsetFunction&) = default;
};

/// Interpolation at the inset lattice and its rule, for all insets at once.
/// Maths     nodes q_j = alpha + (1 - 3 alpha) k/r.  l_k(x) = prod_i prod_{a < k_i} (r (x_i - alpha) - a (1 -
///           3 alpha))/(k_i - a) over (1 - 3 alpha)^r is rational in alpha, and so are the weights Int l_k
///           and the defects of the rule
/// Source    [m06, (13)-(16)]; r = 1: [ac98, (33)-(34), (54)]; the product form is Silvester's
/// Requires  0 <= degree <= 30, else ContractViolation
/// Result    exact, as identities in alpha; functions and nodes in the order of lattice_indices. Degree 0 is
///           constant in alpha
/// Limits    the nodes lie in the triangle for 0 <= alpha <= 1/3, and are different unless alpha = 1/3
class InsetFamily {
public:
  explicit InsetFamily(int degree);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] std::size_t size() const { return indices_.size(); }
  /// The coordinates of the node q_j, each of degree 1 or 0 in alpha.
  [[nodiscard]] std::array<RationalPolynomial, 3> node(std::size_t j) const;
  /// l_j(x) at a fixed point of the plane; ContractViolation unless x_1 + x_2 + x_3 = 1.
  [[nodiscard]] InsetFunction value(std::size_t j, const Barycentric<Rational>& x) const;
  /// The integral of l_j over the triangle.
  [[nodiscard]] InsetFunction weight(std::size_t j) const;
  /// The rule's defect, as radcert::defect has it.
  [[nodiscard]] InsetFunction defect(Region region, const Monomial& monomial) const;
  /// The monic polynomial whose zeros are the insets for which the rule, if it is exact below `precision`, is
  /// exact of degree `precision` as well: the greatest common divisor of the numerators of the defects. Zero:
  /// every inset.
  [[nodiscard]] RationalPolynomial condition(Region region, int precision) const;

private:
  [[nodiscard]] InsetFunction reduced(RationalPolynomial numerator) const;

  int degree_;
  std::vector<std::array<int, 3>> indices_;
  std::vector<RationalPolynomial> weight_numerators_;  ///< over (1 - 3 alpha)^degree
};

}  // namespace radcert
