// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "radcert/core/matrix.h"

namespace radcert {

/// Functions F and F' at a point.
/// Result    derivatives: a row a function, a column an unknown; rounded
struct FunctionsThere {
  std::vector<double> values;
  Matrix<double> derivatives;
};

/// Levenberg's and Marquardt's iteration towards a zero of as many functions as unknowns or fewer.
/// Maths     x + d, d the least |F + F' d|^2 + m |d|^2, m = 1/100 at first. Where |F|^2 falls, the step is
///           taken and m divided by 5; elsewhere m is multiplied by 4, at most eight times
/// Source    Marquardt, Journal of the Society for Industrial and Applied Mathematics 11 (1963)
/// Requires  as many functions at every point
/// Result    whether |F|^2 <= solved within so many steps; x is the last point then and else. Rounded:
///           proves nothing
[[nodiscard]] bool damped_least_squares(
    std::vector<double>& x, const std::function<FunctionsThere(const std::vector<double>&)>& functions,
    double solved, int most_steps);

}  // namespace radcert
