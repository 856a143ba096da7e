// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// The smallest and the largest of Int_S G(P,Q) dS_Q over some points P.
/// Maths     G as it stands, V = 1 even where something is in the way
/// Source    [ac98, (2), (7)]
/// Requires  points off the edges
/// Result    values of reference::operator_integral with the density 1; radii are estimates, the largest over
///           the points
struct Extremes {
  Approximation least{.value = 0, .radius = 0};
  Approximation largest{.value = 0, .radius = 0};
};
[[nodiscard]] Extremes total_factors(const Surface& surface, std::span<const SurfacePoint<double>> points);

/// The least G(P,Q) over all pairs of some points, P != Q.
/// Maths     G by the chord on one chart, by coordinates between two
/// Source    [ac98, (2)]
/// Requires  at least two points
/// Result    rounded; the radius is an estimate of that
/// Limits    a sample, no minimum over S
[[nodiscard]] Approximation least_kernel(const Surface& surface,
                                         std::span<const SurfacePoint<double>> points);

}  // namespace radcert::verification::ac98
