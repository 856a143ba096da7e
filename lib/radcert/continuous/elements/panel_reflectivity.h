// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/continuous/elements/panel.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The reflectivity of a panel, and what its supremum lies between.
/// Maths     rho a polynomial of the parameters of plane_coordinates, 0 <= rho on the panel, seen <= sup rho
///           <= largest
struct PanelReflectivity {
  /// A constant.
  PanelReflectivity(const Rational& constant);  // NOLINT(google-explicit-constructor): exact
  PanelReflectivity(PlanePolynomial<Rational> rho, Rational at_most, Rational at_least)
      : polynomial(std::move(rho)), largest(std::move(at_most)), seen(std::move(at_least)) {}

  PlanePolynomial<Rational> polynomial;
  Rational largest;
  Rational seen;

  [[nodiscard]] bool is_constant() const { return polynomial.degree() == 0; }
};

/// Proves that a polynomial lies between 0 and 1 on a panel, as a reflectivity has to.
/// Maths     on each triangle of a fan, and on halves of it, a polynomial lies between the least and the
///           largest of its Bernstein coefficients, of which those at the corners are its values there.
///           Triangles are halved until no coefficient is negative, and none is above a value that is seen by
///           more than a 1024th of its distance from 1
/// Source    G. Farin, "Curves and Surfaces for CAGD", chapter 17: the convex hull property
/// Requires  a polynomial of the parameters of plane_coordinates
/// Result    exact: 0 <= rho <= largest < 1 on the panel; refused where that is false, or not proved
/// Limits    a polynomial that touches 0 inside the panel, and not along a side of one of these triangles, is
///           not proved to be positive
[[nodiscard]] Outcome<PanelReflectivity> reflectivity_of(const Panel& panel,
                                                         const PlanePolynomial<Rational>& rho);

}  // namespace radcert
