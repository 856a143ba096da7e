// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/closed_form/edge/edge_symbol.h"

namespace radcert {

/// EdgeSymbol::entire near one point as a polynomial with an error: for sets of exponents, over which the
/// series itself forgets how its factors depend on each other.
/// Maths     beta = b (b+1), beta_0 that of the centre, d = beta - beta_0. The first N terms of F, N >=
///           (|beta_0| + rho)/2, are a polynomial in beta; its Taylor polynomial at beta_0 below degree J is
///           kept. As |n (n+1) - beta| <= n (n+1) + B for |beta| <= B = |beta_0| + rho, the terms are at most
///           A_n x^n there, A_n the product of (m (m+1) + B)/((m+1)(m+2)), m < n. So by Cauchy, M = sum A_n
///           x^n, q = r/rho, for |d| <= r the rest from degree J on is at most M q^J/(1-q), its derivative at
///           most M q^J (J+1)/((1-q)^2 r). The terms from N on are at most A_N x^N/(1-x) =: t as in
///           EdgeSymbol::entire, the derivative of their sum at most t/(rho-r)
/// Source    ours
/// Requires  r > 0
/// Result    at the precision current when it was made
class EdgeSymbolPatch {
public:
  /// For all b of a set, taken as its midpoint and what is around it.
  EdgeSymbolPatch(const EdgeSymbol& symbol, const ComplexBall& set);

  /// As EdgeSymbol::entire; a failure where b is not within the set.
  [[nodiscard]] SymbolValue entire(const ComplexBall& b) const;

private:
  ComplexBall set_;
  ComplexBall centre_;
  Ball x_;
  std::vector<ComplexBall> coefficients_;
  Ball error_;
  Ball slope_error_;
};

}  // namespace radcert
