// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/core/outcome.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A plane element of space, known exactly: corners counterclockwise as seen from the side of the inner
/// normal.
using ExactTriangle = std::array<Vector<Rational>, 3>;

/// A node in the unit of length in which it is exact; the normal is not of unit length.
struct ExactNode {
  Vector<double> point;
  Vector<double> normal;
};

/// The collocation nodes of plane elements in a unit of length in which their doubles are exact.
/// Maths     node k p + j is scale (x_1 c_1 + x_2 c_2 + x_3 c_3), x the exact coordinates of node j, c the
///           corners of element k; its normal has the direction of (c_2 - c_1) x (c_3 - c_1)
/// Requires  elements not degenerate, else ContractViolation
/// Result    scale times any node or corner is a vector of whole numbers. Refused where these do not fit into
///           doubles
/// Limits    numbers of decimals such as 0.1 with 53 binary digits leave no room: their nodes are refused
struct ExactNodes {
  Rational scale = 1;
  std::vector<ExactNode> nodes;
};
[[nodiscard]] Outcome<ExactNodes> exact_nodes(std::span<const ExactTriangle> elements,
                                              const LagrangeFunctions& functions);

/// Lagrange functions by their monomials in s = x_2, t = x_3; exact.
[[nodiscard]] std::vector<PlanePolynomial<Rational>> by_monomials(const LagrangeFunctions& functions);

/// An element prepared for nodes in that unit of length.
/// Requires  functions by their monomials, as by_monomials gives them; an element that is not degenerate
[[nodiscard]] PlaneElement plane_element(const ExactTriangle& element, const Rational& scale,
                                         const std::vector<PlanePolynomial<Rational>>& functions);

/// Error bounds of the integrals of Lagrange functions by PlaneElement.
/// Maths     accuracy Int |G| max |l_j|. Int |G| = |Int G| where G has one sign, and Int G is the sum of the
///           integrals, as the l_j have the sum 1: it is at most the size of that sum and what the integrals
///           and the sum are off by
/// Source    PlaneElement
/// Result    rounded up. Refused where the functions do not have the sum 1, and where they are so large that
///           the integrals say nothing of their sum
/// Limits    max |l_j| is bounded by the Bernstein coefficients
class IntegralErrors {
public:
  [[nodiscard]] static Outcome<IntegralErrors> of(const LagrangeFunctions& functions);
  /// Of each of the integrals of an element or of a part of it that are given, one a function.
  [[nodiscard]] double bound(std::span<const double> integrals) const;
  /// A number of at least max |l_j| for all j.
  [[nodiscard]] double largest_value() const { return largest_; }

private:
  explicit IntegralErrors(double largest) : largest_(largest) {}
  double largest_;
};

/// reflectivity / pi times an integral that is off by at most `error`; encloses the exact product.
[[nodiscard]] Approximation certified_entry(double reflectivity, double integral, double error);

}  // namespace radcert
