// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/approximation.h"
#include "radcert/study/computed_function.h"

namespace radcert {

/// Errors of u_n in means.
/// Maths     l2 = (Int_S (u - u_n)^2 dS)^(1/2); mean = max over the pieces of |Int (u - u_n) dS| / area
/// Result    plain data
struct MeanErrors {
  Approximation l2;
  Approximation mean;
};

/// The errors of u_n in means, by a conical rule on each element.
/// Maths     the rule of order + 1 counts; its radius, where there is one, is what that of `order` differs by
/// Requires  l2_radius: of u_n in the L2 norm, absent where nothing is known of it
/// Result    with a radius where l2_radius is given: that, over the root of the piece's area for a mean, and
///           what the rules differ by; estimated. Nothing where u is not finite at a point
/// Limits    rounding of u is not counted beyond that of the sums
[[nodiscard]] std::optional<MeanErrors> mean_errors(const ComputedFunction& u_n,
                                                    const PiecewiseExpression& solution, int order,
                                                    std::optional<double> l2_radius);

}  // namespace radcert
