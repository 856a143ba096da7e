// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/study/study.h"
#include "verification/framework/check.h"
#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// A problem with a known solution and exact geometry.
[[nodiscard]] Problem known_problem(const std::string& surface, std::vector<SurfaceParameter> parameters,
                                    const std::string& reflectivity, const std::string& solution, int degree,
                                    const Rational& alpha);

/// The order between two errors.
/// Maths     log2(coarse/fine)/steps
/// Requires  `fine` belongs to a mesh size divided by 2^steps
/// Result    the radius covers those of both errors; not finite where one of them may be 0
[[nodiscard]] Approximation order_between(const Approximation& coarse, const Approximation& fine,
                                          int steps = 1);

/// The errors of a level at its nodes, apart.
/// Maths     max |u - u_n| over all nodes, over those of elements with a side or a corner on the border of
///           their chart, and over the others
/// Requires  a problem with `solution`
/// Result    with the radius of the level's node error
/// Limits    a part without nodes is 0
struct NodeErrors {
  Approximation all{.value = 0, .radius = 0};
  Approximation at_seams{.value = 0, .radius = 0};
  Approximation inside{.value = 0, .radius = 0};
};
[[nodiscard]] NodeErrors node_errors(const Bench& bench, const Problem& problem, int level);

}  // namespace radcert::verification::ac98
