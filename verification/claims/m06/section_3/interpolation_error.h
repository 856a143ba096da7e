// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/rational_polynomial.h"

namespace radcert::verification::m06 {

/// The regions of Lemmas 5, 6 and 8, and one that is none of theirs.
enum class Over {
  triangle,  ///< sigma, with x = s and y = t
  square,    ///< sigma and its half turn, the unit square cut from (0,1) to (1,0); x, y from its centre
  kite,      ///< sigma and its mirror image in the side s = 0, x = +-s and y = t: no parallelogram
};

/// What a factor Phi sees of what interpolation at the nodes (13) leaves over, for all alpha at once.
/// Maths     B(Phi, g) = Int Phi (I - L) g = Int Phi g - sum_j g(q_j) Int Phi l_j, Phi and g monomials in x
///           and y, L on each half; times (1 - 3 alpha)^r a polynomial in alpha
/// Source    [m06, (13)-(15), (30), (31), (38)]
/// Requires  0 <= degree <= 8, else ContractViolation
/// Result    exact, as identities in alpha. Integrals by a rule with rational nodes and weights, the lattice
///           of degree r + 3, which is exact for them
/// Limits    Phi of degree <= 1 and g of degree <= r + 2, else ContractViolation
class InterpolationError {
public:
  explicit InterpolationError(int degree);
  /// (1 - 3 alpha)^r B(Phi, g).
  [[nodiscard]] RationalPolynomial operator()(Over region, const Monomial& phi, const Monomial& g) const;

  /// How many coefficients of the remainders by `modulus` are not zero, over all Phi and g with these total
  /// degrees: zero if B vanishes at all zeros of the modulus other than 1/3. A modulus of zero asks for all
  /// alpha.
  [[nodiscard]] Rational coefficients_left(Over region, int of_phi, int of_g,
                                           const RationalPolynomial& modulus) const;

private:
  /// x = sign s + shift, and the same for y.
  struct Half {
    int x_sign;
    int y_sign;
    Rational shift;
  };
  /// (1 - 3 alpha)^r Int Phi l_j over one half.
  struct OfFunctions {
    Half half;
    std::vector<RationalPolynomial> integrals;
  };
  [[nodiscard]] static std::vector<Half> halves(Over region);
  [[nodiscard]] std::vector<OfFunctions> of_functions(Over region, const Monomial& phi) const;
  [[nodiscard]] RationalPolynomial error(const std::vector<OfFunctions>& functions, const Monomial& phi,
                                         const Monomial& g) const;

  int degree_;
  InsetFamily family_;
  std::vector<Barycentric<Rational>> points_;
  std::vector<Rational> weights_;
  std::vector<std::vector<RationalPolynomial>> values_;  ///< (1 - 3 alpha)^r l_j at each point
};

}  // namespace radcert::verification::m06
