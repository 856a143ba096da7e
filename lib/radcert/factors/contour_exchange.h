// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/factors/shadow_exchange.h"
#include "radcert/scalar/ball.h"

namespace radcert {

extern const WorkLimit most_contour_pieces;

/// The accuracy demanded of an exchange area by contours, and the work allowed.
struct ContourDemand {
  double radius = 1e-10;  ///< of the exchange area
  long work_limit = most_contour_pieces.value();
};

/// The direct exchange area of two polygons past any number of convex screens, enclosed.
/// Maths     E = 1/pi Int_R f dS, f(P) = 1/2 sum over the edges of the contour that P sees of Int (V+ - V-)
///           n . ((X - P) x u) / |X - P|^2 dt, Lambert's flux. Integrated over P first, each edge gives an
///           integral over its own parameter of a function that is analytic but where the order of some lines
///           changes: ContourEdge, CriticalLines. E is that without screens, and from each side of the
///           source what is seen less the whole, and what is seen of each edge of a screen
/// Source    ours, from Lambert and Stokes
/// Requires  convex polygons without three corners in a line; receiver and source wholly in front of each
///           other's planes, points of the plane allowed; `unoccluded` encloses the exchange area without
///           screens; radius > 0
/// Result    an enclosure: the pieces of edges with the largest bounds are halved until these come to the
///           radius, or the work limit: then what was reached. No value where source and screens have sides
///           in the receiver's plane
/// Limits    pieces shrink geometrically about changes of order, and to edges that end on the receiver
[[nodiscard]] std::optional<Ball> contour_exchange_area(const ExactCorners& receiver,
                                                        const ExactCorners& source,
                                                        const std::vector<ExactCorners>& screens,
                                                        const Ball& unoccluded, const ContourDemand& demand);

}  // namespace radcert
