// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/enclosure/square_function.h"

namespace radcert {

/// A bound of a function on a Bernstein ellipse of one variable, for all real values of the other in a cell.
/// Maths     M >= sup |f(z, y)|, z in the ellipse with half axes h (rho + 1/rho)/2, h (rho - 1/rho)/2 around
///           the middle of the cell's side of length 2h, y in the other side
/// Source    the closed upper half of the ellipse times the side is covered by products of two disks, over
///           each of which the model of f is finite: f is analytic around each. f is real on the real line,
///           so the reflection f(conj z) = conj f(z) continues it to the lower half with the same bound
/// Requires  rho > 1 and budget >= 1
/// Result    bound = M, infinite where `budget` evaluations did not show that f is analytic; the products
///           with the largest bounds are halved until the bound is within a factor 16 of the value in the
///           middle or the budget is spent
/// Limits    M may be far above the supremum: its logarithm is what enters the number of nodes
struct EllipseBound {
  double bound;
  long evaluations;
  const char* failure;  ///< of the product that has no bound; null where there is a bound
};
[[nodiscard]] EllipseBound bound_on_ellipse(const SquareFunction& f, const SquareCell& cell, SquareAxis axis,
                                            double rho, long budget);

}  // namespace radcert
