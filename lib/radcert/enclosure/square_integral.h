// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/enclosure/demand.h"
#include "radcert/enclosure/square_function.h"

namespace radcert {

/// The sum of the integrals of several functions over the unit square, enclosed.
/// Maths     sum_k Int_0^1 Int_0^1 f_k(x, y) dx dy
/// Source    ours. The squares are bisected until each cell has an enclosure of its own: a product Gauss rule
///           with |Int Int f - Q_x Q_y f| <= 2 h_x h_y (e_x + e_y), e the error of gauss_error_factor for sup
///           |f| on Bernstein ellipses of x (y in its interval) and of y, the weights of a rule having the
///           sum 2; or the area times the values over the cell, which asks for no derivative
/// Requires  radius > 0, work_limit >= 1, else ContractViolation
/// Result    a ball of radius <= demand.radius; else undecided, with what was reached when the work limit
///           left no cell that could be finished, when a cell could not be bisected any more, or when
///           rounding at BallPrecision::current() is wider than the demand. At most work_limit evaluations.
///           The same bits for every number of threads
/// Limits    where f is not analytic the work grows as the demand falls: to points and to lines parallel to
///           an axis cells shrink geometrically; along other lines the number of cells grows with the
///           reciprocal of their size
[[nodiscard]] Enclosure integral_over_squares(std::span<const SquareFunction> functions,
                                              const Demand& demand);

}  // namespace radcert
