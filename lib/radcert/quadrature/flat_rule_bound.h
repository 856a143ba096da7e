// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace radcert {

/// A bound for the truncation error of a conical rule over a plane element, seen from a distance.
/// Maths     h the distance of P from the element's plane, A the element's area, r the radius of a ball about
///           the element with centre c, R = |P-c|, eta = R/r > 1:
///             |Int G l_j dS - rule| <= bound(n, d, eta) (A h / R^3) max|l_j|,
///             bound = 8 rho^(d+1-2n)/(rho-1) (1+theta)/(1-theta)^4,  theta = sqrt(1 + g^2)/eta,  g = (rho +
///             1/rho)/2,
///           for every rho > 1 with theta < 1; the smallest over 32 values of theta is returned.
///           Each variable of the rule runs along a chord of the ball, of half length a <= r. For a complex
///           point z of that variable in the Bernstein ellipse rho, |P-Q(z)|^2 = a^2 (z-z_0)(z-conj z_0),
///           |z_0| = |P-m|/a, m the middle of the chord, so that |P-Q(z)| >= |P-m| - a g >= R - r
///           sqrt(1+g^2); in the same way |(Q-P).n_P| <= R + r sqrt(1+g^2); |(P-Q).n_Q| = h. |l_j| grows by
///           rho^d at most (Bernstein). The best polynomial of degree m differs by 2 M rho^-m/(rho-1) at
///           most, and a rule of positive weights, exact for degree 2n - 1, by twice that; two variables
/// Source    ours; ellipses: Trefethen, Approximation Theory and Approximation Practice, Theorems 8.2 and
///           19.3
/// Requires  n >= 1, degree d >= 0 of the basis; eta > 1
/// Result    a proved bound for the exact rule, rounded as double rounds; infinite where no theta helps
/// Limits    plane elements: there G l_j is rational. About 10 to 100 times too large
inline double flat_rule_bound(int n, int degree, double eta) {
  constexpr int tries = 32;
  double least = HUGE_VAL;
  for (int k = 1; k < tries; ++k) {
    const double theta = static_cast<double>(k) / tries;
    const double reach = theta * eta;
    if (reach * reach <= 2) continue;  // rho > 1 needs g > 1
    const double g = std::sqrt(reach * reach - 1);
    const double rho = g + std::sqrt(g * g - 1);
    const double growth = (1 + theta) / std::pow(1 - theta, 4);
    least = std::min(least, 8 * std::pow(rho, degree + 1 - 2 * n) / (rho - 1) * growth);
  }
  return least;
}

}  // namespace radcert
