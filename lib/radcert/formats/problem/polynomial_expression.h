// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/core/outcome.h"
#include "radcert/expression/expression.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The polynomial that an expression in barycentric coordinates is.
/// Maths     f(x_1, x_2, x_3) with x_1 = 1 - s - t, x_2 = t, x_3 = s, multiplied out
/// Requires  an expression in x1, x2, x3, else ContractViolation
/// Result    exact; its degree is that of the polynomial, whatever cancels. Otherwise the reason: an
///           operation that leaves the polynomials, such as sqrt or a division by a coordinate, or a degree
///           above the largest
/// Limits    exponents are whole numbers that are written as such
[[nodiscard]] Outcome<PlanePolynomial<Rational>> polynomial_of(const Expression& expression,
                                                               int largest_degree);

/// The coefficients of a polynomial in s = x_3, t = x_2 for the Bernstein polynomials of a degree.
/// Maths     s^a t^b = x_3^a x_2^b (x_1 + x_2 + x_3)^(D - a - b)
/// Source    Farin, "Curves and surfaces for CAGD"
/// Requires  degree >= the polynomial's, else ContractViolation
/// Result    exact, in the order of lattice_indices(degree)
[[nodiscard]] std::vector<Rational> bernstein_coefficients(const PlanePolynomial<Rational>& polynomial,
                                                           int degree);

}  // namespace radcert
