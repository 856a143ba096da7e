// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The corners of a convex plane polygon, exactly, counterclockwise as seen from its front.
using ExactCorners = std::vector<Vector<Rational>>;

/// From where an occluder hides something.
enum class OccludingSide { both, front };

extern const WorkLimit most_shadow_evaluations;

/// The accuracy demanded of the enclosure of a shadow, and the work allowed.
struct ShadowDemand {
  double radius = 1e-12;  ///< of the exchange area
  long work_limit = most_shadow_evaluations.value();
};

/// The direct exchange area that one convex occluder keeps back, enclosed.
/// Maths     B = 1/pi Int_R b(P) dS, b(P) = -1/2 sum_k gamma_k n_R.n_k / |n_k| over the sides of the
///           occluder's shadow on the source as P sees it: the source beyond the occluder's plane, in the
///           pyramid from P over the occluder. n_k = (A - P) x (B - A), A and B two fixed points on the line
///           of side k; gamma_k the angle between its corners d_k and d_(k+1), d_k = V - P at a corner V of
///           occluder or source, else +-n_(k-1) x n_k
/// Source    Lambert's flux of a polygon. Which sides the shadow has changes only where a side of occluder or
///           source and a corner of the other lie in a plane with P, or P in the occluder's plane: the
///           receiver is cut along these planes, exactly, and on each cell b is one analytic formula, which
///           integral_over_polygon encloses
/// Requires  convex polygons, receiver and source wholly in front of each other's planes, points of the plane
///           allowed
/// Result    an enclosure at the current precision of a radius of about the one demanded; no value where the
///           work limit left nothing bounded. Exactly 0 where there is no shadow. front: only where P lies in
///           front of the occluder
/// Limits    b is not analytic where the receiver touches the occluder's pyramids' apex lines or the source's
///           plane: slower there
[[nodiscard]] std::optional<Ball> shadow_exchange_area(const ExactCorners& receiver,
                                                       const ExactCorners& source,
                                                       const ExactCorners& occluder, OccludingSide side,
                                                       const ShadowDemand& demand);

}  // namespace radcert
