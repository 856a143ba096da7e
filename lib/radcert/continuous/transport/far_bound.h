// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/continuous/elements/lagrange_table.h"

namespace radcert {

/// What a part e of an element sends to observers on a line, far from it, as a function of their parameter.
/// Maths     P runs along a line of the half length h, x in [-1,1] its parameter; the ball about e is further
///           than D from the middle, a = 3/4 D. For x in the ellipse with the foci -1, 1 and the larger half
///           axis A = a/h, the kernel of P and of Q in e has the modulus kernel_in_ellipse(D, a, H) at most:
///           it is symmetric, P is in a plane of which Q has the height H at most. So T_e f is holomorphic
///           there, |T_e f| <= M = m kernel_in_ellipse(D, a, H), m = |e| sup|f| / pi, and some polynomial of
///           degree n - 1 is off by polynomial_error_factor(n, A + (A^2-1)^(1/2)) M. Where A > 2, the ellipse
///           of A = 2 is no nearer than 1 to any x: |d/dx T_e f| <= m kernel_in_ellipse(D, 2h, H), by Cauchy
/// Result    rounded up; infinite where A <= 2
class FarBound {
public:
  /// distance: at most D; half, height, mass: at least h, H, m
  FarBound(double distance, double half, double height, double mass);
  [[nodiscard]] double of_polynomials(int nodes) const;
  [[nodiscard]] double of_slope() const { return slope_; }
  /// About the least number of nodes for which interpolation is off by what is allowed, or more than
  /// most_gauss_nodes.
  [[nodiscard]] int needed(double allowed) const;

private:
  double rho_ = 0;
  double most_ = 0;  ///< M
  double slope_ = 0;
};

/// What several parts leave in all, by the variables of a box of observers.
struct FarError {
  double in_s = 0;  ///< between F and polynomials, on lines in s
  double in_t = 0;
  double slope = 0;       ///< of F, in s and in t
  std::size_t parts = 0;  ///< so many terms each

  void add(const FarBound& of_s, const FarBound& of_t, int nodes_s, int nodes_t);
  /// |F - I F| for the interpolant of values that are off by `off` and no larger than `size`, at the points
  /// of two tables.
  /// Maths     l_s, l_t the largest sums of moduli: |F - I_s I_t F| <= |F - I_s F| + |I_s (F - I_t F)| <=
  ///           (1+l_s) e_s + l_s (1+l_t) e_t, since I_s keeps the polynomial that is e_s from F; 16 u times
  ///           the slopes, since points are known to 16 u; l_s l_t times what values are off by, and
  ///           roundings: 4 n u for each Lagrange polynomial of n nodes, n u for each sum
  /// Result    rounded up
  [[nodiscard]] double of_interpolant(const LagrangeTable& table_s, const LagrangeTable& table_t, double off,
                                      double size) const;
};

}  // namespace radcert
