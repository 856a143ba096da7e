// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/rules/degree_of_precision.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// How far a rule is exact whose points and weights are enclosed.
/// Maths     exact for every polynomial up to `degree`; not for first_failure, of degree + 1, whose defect is
///           enclosed
/// Source    as Precision
/// Result    0 is not in `defect`
/// Limits    first_failure: the first monomial, by falling powers of s, whose defect is certainly not zero
struct EnclosedPrecision {
  int degree = -1;
  Monomial first_failure;
  Ball defect;
};

/// The proved facts of symmetric nodes.
/// Maths     within `radius` of every coordinate that is not held there is exactly one choice of them, with
///           one of the weights within `radius` of those of the interpolatory rule, for which the rule is
///           exact of the degree that was claimed; these true nodes are unisolvent for polynomials of no
///           larger degree, so that the rule is their interpolatory one, and lie inside the triangle
/// Source    Krawczyk 1969
/// Requires  made by certify
/// Result    rule: points and weights of the true set, enclosed; determinant: det (B_k(q_j)) there, or det
///           (f_k(q_j)) of the functions of a space
struct SymmetricCertificate {
  Rational radius;
  TriangleRule<Ball> rule;
  Ball determinant;
  EnclosedPrecision triangle;
  EnclosedPrecision parallelogram;
};

/// Proves that symmetric nodes lie at a rule of high precision.
/// Maths     F_k = sum over orbits of size w (e_2^i e_3^j)(q) - Int e_2^i e_3^j for all 2i + 3j <= precision,
///           with the elementary symmetric functions e_2, e_3 of the barycentric coordinates: a symmetric
///           rule is exact for all polynomials of a degree if and only if it is for the invariant ones. X:
///           the box of half-width `radius` about x, K(X) = x - Y F(x) + (I - Y F'(X))(X - x), Y an
///           approximate inverse: K(X) inside X proves one zero in X, and K(X) encloses it
/// Source    Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", Computing 4,
///           1969
/// Requires  orbits of size 1, 3, 6; radius > 0; precision >= degree; `space` is empty, for all polynomials
///           of the degree, or has functions of s = x_3, t = x_2 up to that degree, else ContractViolation
/// Result    the certificate; or why there is none: numbers of unknowns and equations that differ, nodes that
///           are not unisolvent or not inside, an image that is not inside the box
/// Limits    works at 512 bits; a refusal does not prove that there is no such rule
[[nodiscard]] Outcome<SymmetricCertificate> certify(const SymmetricNodes& nodes, const Rational& radius,
                                                    std::span<const PlanePolynomial<Rational>> space = {});

}  // namespace radcert
