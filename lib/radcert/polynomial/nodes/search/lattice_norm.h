// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// The norm of interpolation as it is seen at points: max sum_j |l_j|.
/// Requires  (degree + 1)(degree + 2)/2 nodes, at least one point
/// Result    rounded, below the norm; no number where the nodes are not unisolvent. lebesgue_constant
///           encloses the norm itself
[[nodiscard]] double norm_at(std::span<const Barycentric<double>> points, int degree,
                             std::span<const Barycentric<double>> nodes);

}  // namespace radcert
