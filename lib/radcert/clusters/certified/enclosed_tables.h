// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// Step functions above the sizes of basis functions on an element.
/// Maths     bounds(i, j) >= |l_j| on part i of the 64 that three symmetric refinements make of it, in the
///           order of Triangulation; q_j the function with these values. size: at least the root of the mean
///           of (sum_j q_j)^2
/// Source    the Bernstein coefficients of l_j on the part, of which its values are convex combinations;
///           blossoms: Farin, Curves and Surfaces for CAGD, chapter 17
/// Requires  functions of degree at most 8
/// Result    proved, by running errors
struct StepFunctions {
  explicit StepFunctions(const LagrangeFunctions& functions);
  static constexpr int cuts = 3;
  std::vector<std::vector<double>> bounds;  ///< by part
  double size = 0;
};

/// The constants of cluster operators, enclosed.
/// Maths     transfer[c](n, m) as ModeTables::to_parent, moments and values as LeafTables, and sizes(n, k p +
///           j) = mean over the leaf of q_j on its element k times D_n, q_j of StepFunctions
/// Source    Gauss rules in balls that are exact for the products; the nodes of the elements are the exact
///           ones, and their corners in the leaf dyadic numbers
/// Requires  0 <= refinements; 0 <= degree <= largest_mode_degree; functions of degree at most 8
/// Result    balls of about the current precision, up to the degree
struct EnclosedTables {
  EnclosedTables(const LagrangeFunctions& functions, const StepFunctions& steps, int refinements, int degree);

  std::size_t unknowns;
  std::array<Matrix<Ball>, 4> transfer;
  Matrix<Ball> moments;
  Matrix<Ball> sizes;
  Matrix<Ball> values;
};

}  // namespace radcert
