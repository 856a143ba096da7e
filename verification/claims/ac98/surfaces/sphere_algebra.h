// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "radcert/scalar/rational.h"
#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// Equation (1) on the unit sphere at one point P, for any data: an equation of four numbers.
/// Maths     G = 1/4 for all P != Q, so that K u = rho M(u) with the mean M over the sphere, which is linear.
///           With a = E(P), b = rho(P), e = M(E), r = M(rho):  u = E + c rho, c = e/(1 - r), has M(u) = e + c
///           r
/// Source    [ac98, (1)]; G: [m06, Lemma 1 (d)]
/// Requires  r != 1
/// Result    exact
struct SphereEquation {
  Rational emission;           ///< a
  Rational reflectivity;       ///< b
  Rational mean_emission;      ///< e
  Rational mean_reflectivity;  ///< r

  explicit SphereEquation(const std::array<Rational, 4>& x)
      : emission(x[0]), reflectivity(x[1]), mean_emission(x[2]), mean_reflectivity(x[3]) {}

  [[nodiscard]] Rational multiple() const { return mean_emission / (1 - mean_reflectivity); }  ///< c
  [[nodiscard]] Rational solution(const Rational& c) const { return emission + c * reflectivity; }
  [[nodiscard]] Rational mean_solution(const Rational& c) const {
    return mean_emission + c * mean_reflectivity;
  }
  /// u(P) - rho(P) M(u) - E(P).
  [[nodiscard]] Rational residual(const Rational& c) const {
    return solution(c) - reflectivity * mean_solution(c) - emission;
  }
};

/// Requires that the kernel of the library is 1/4 between all points of the unit sphere, with inner normals,
/// and that u = E + c rho solves (1) for all data.
/// Maths     P and Q by stereographic projection from (0,0,-1), with D_P, D_Q the denominators and M = D_P
///           D_Q - N_P.N_Q:  |P-Q|^2 = 2M/(D_P D_Q), and both products of (2) are M/(D_P D_Q) if and only if
///           G = 1/4, an identity of degree 4 at most in each of four variables. (1) is one of degree 2 at
///           most, over 1 - r
void require_solution_on_the_sphere(Finding& finding);

/// Requires that |u| <= norm of E/(1 - norm of rho) for that u, and for every linear M with |M(f)| <= norm of
/// f and M(f) >= 0 where f >= 0.
/// Maths     with e = norm of E, n = norm of rho < 1, r = M(rho):  |u| <= e (1 + n/(1 - r)), and e/(1 - n)
///           less that is e n (n - r)/((1 - n)(1 - r)) >= 0, as 0 <= r <= n
void require_norm_of_the_solution(Finding& finding);

}  // namespace radcert::verification::ac98
