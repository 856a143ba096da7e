// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// As many functions as unknowns, F, and F', on a box.
/// Result    derivatives: a row a function, a column an unknown; enclosed
struct BallResiduals {
  std::vector<Ball> values;
  Matrix<Ball> derivatives;
};

/// Newton's method in balls, whose radii are dropped at each step.
/// Requires  `residuals` of the unknowns as they are when it is called
/// Result    whether the last of at most 12 steps was below 1e-70; proves nothing
[[nodiscard]] bool newton(std::span<Ball* const> unknowns, const std::function<BallResiduals()>& residuals);

/// Krawczyk's test.
/// Maths     K = c - Y F(c) + (I - Y F'(X)) (X - c), Y an approximate inverse of F'(c), X the box of all
///           numbers within the radius of c. If K lies in the interior of X, F has exactly one zero in X, and
///           it lies in K
/// Source    Krawczyk (1969); Rump, Acta Numerica 19 (2010), section 13
/// Requires  as many functions as unknowns; `box` starts as the centre; `over_box` is F and F' on the box as
///           it is when it is called; radius > 0
/// Result    the box is K; or why nothing is proved, and then the box is of no use
[[nodiscard]] Outcome<void> krawczyk(std::span<Ball* const> centre, std::span<Ball* const> box,
                                     const Rational& radius, const BallResiduals& at_centre,
                                     const std::function<BallResiduals()>& over_box);

}  // namespace radcert
