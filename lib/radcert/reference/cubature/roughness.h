// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace radcert::reference {

/// How far an integrand on the unit square is from a polynomial, in either direction.
/// Maths     the length of the interval in units of the distance of the nearest singularity from it in the
///           complex plane: `across` for the number y of a line, `along` for the place x on it
/// Source    the error of Gauss's rule with n points is about rho^(-2n), rho = b + sqrt(1 + b^2) for a
///           singularity above the middle of an interval of length 2/b times its distance
/// Requires  >= 0
/// Result    how many points a part is given at first, and how far the fall of its coefficients is continued
/// Limits    a guess: it decides what the integral costs, and the adaptive rule whether it is right
struct Roughness {
  double across;
  double along;
  double share = 1;  ///< of the part in the whole, roughly: a small one needs fewer digits
  bool analytic =
      true;  ///< no singularity but those that the lengths tell of; else errors are estimated with less trust
};

/// How many equal regions a direction is cut into at first, and the points in each.
struct Cut {
  std::size_t regions;
  std::size_t points;
};

/// The cut that a roughness asks for in one direction, or in both.
/// Maths     1 + (25 + 0.6 log(share)) / log(rho) points: rho^(-1.5 points), which is about what GaussRule
///           estimates, is then below 1e-16
/// Source    see Roughness
/// Requires  roughness >= 0, 0 < share <= 1
/// Result    points between those of the smallest and the largest GaussRule, along the lines a multiple of
///           Pack::lanes
Cut cut_across(const Roughness& roughness);
Cut cut_along(const Roughness& roughness);

}  // namespace radcert::reference
