// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/differing_coefficients.h"

namespace radcert::verification::ac98 {
namespace {

RationalPolynomial times_shrinkage(RationalPolynomial p, int exponent) {
  const RationalPolynomial shrinkage = 1 - 3 * RationalPolynomial::variable();
  for (int k = 0; k < exponent; ++k) p *= shrinkage;
  return p;
}

}  // namespace

Rational differing_coefficients(const InsetFunction& a, const InsetFunction& b) {
  const RationalPolynomial difference =
      times_shrinkage(a.numerator, b.pole_order) - times_shrinkage(b.numerator, a.pole_order);
  long count = 0;
  for (int k = 0; k <= difference.degree(); ++k)
    if (difference.coefficient(static_cast<std::size_t>(k)) != 0) ++count;
  return count;
}

}  // namespace radcert::verification::ac98
