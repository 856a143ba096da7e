// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// Nodes for interpolation by polynomials of high degree on a triangle.
/// Maths     x(a) for a = (a_1,a_2,a_3) >= 0, |a| = p: the mean, over the three sides, of the point of the
///           side i that belongs to a without a_i, by the weights g(p, p - a_i);  on a side of n + 1 points
///           these are g(n, k), the Gauss-Lobatto-Legendre points of [0,1]
/// Source    T. Isaac, "Recursive, parameter-free, explicitly defined interpolation nodes for simplices",
///           SIAM J. Sci. Comput. 42 (2020)
/// Requires  0 <= degree <= largest_mode_degree, else ContractViolation
/// Result    (p+1)(p+2)/2 points of the closed triangle, a_1 falling, then a_2 falling; symmetric in the
///           vertices up to rounding. Lebesgue constants 2.7, 5.1, 6.7, 9.3, 18 and 66 for p = 4, 8, 10, 12,
///           15 and 20, which a test measures
std::vector<Barycentric<double>> interpolation_nodes(int degree);

}  // namespace radcert
