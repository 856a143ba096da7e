// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/ball.h"

namespace radcert::verification::ac98 {

/// The radiosity equation on the unit sphere for data that are polynomials in z^2, solved exactly.
/// Maths     G = 1/4: K u = rho M(u), M the mean over the sphere, so that u = E + rho M(E)/(1 - M(rho)).
///           M(z^(2k)) = 1/(2k + 1)
/// Source    [ac98, (1)]; G: [m06, Lemma 1 (d)]
/// Requires  M(rho) != 1
/// Result    exact; emission, reflectivity and solution as polynomials in w = z^2, 0 <= w <= 1
struct SphereSolution {
  std::string name;
  RationalPolynomial emission;
  RationalPolynomial reflectivity;
  RationalPolynomial solution;
};
[[nodiscard]] SphereSolution sphere_solution(std::string name, const RationalPolynomial& emission,
                                             const RationalPolynomial& reflectivity);
[[nodiscard]] Rational mean_over_the_sphere(const RationalPolynomial& in_z_squared);

/// max |f(w)| over 0 <= w <= 1 of a linear polynomial, at one of the ends. ContractViolation if the degree is
/// more than 1.
[[nodiscard]] Rational largest_of_linear(const RationalPolynomial& f);

/// Solutions whose data and themselves are linear in z^2, so that their norms are exact: constant and varying
/// rho, constant and varying E.
[[nodiscard]] std::vector<SphereSolution> linear_sphere_solutions();

/// The two parts of (1) at the point (1/5, 1/3) of the first octant, by enclosed double integrals over the
/// library's charts: u(P) - E(P), and rho(P)/pi Int G u.
/// Source    [ac98, (1)]
/// Result    balls; the second of about this radius
struct SphereParts {
  Ball beyond_emission;
  Ball reflected;
};
[[nodiscard]] SphereParts sphere_parts(const SphereSolution& problem, double radius);

}  // namespace radcert::verification::ac98
