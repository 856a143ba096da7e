// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/factors/shadow_exchange.h"

namespace radcert {

/// A segment at which what points of a receiver see of a source may end.
/// Maths     X(t) = from + t u, u = to - from. A direction from P that passes X on its positive side is one
///           with (X - P) x u . d > 0. What is seen there and on the negative side, V+ and V-, are the
///           products of a factor that both have, 1 where no screen of `apart` stands between and, if
///           `source_is_apart`, the source is met, and of one that depends only on which faces at X look
///           where
struct ContourEdge {
  Vector<Rational> from;
  Vector<Rational> to;
  bool source_is_apart = true;     ///< its plane does not contain the edge
  std::vector<std::size_t> apart;  ///< the screens whose planes do not contain the edge
  /// A part of the receiver on which the second factors are constant.
  struct Part {
    ExactCorners receiver;
    int seen = 0;   ///< the difference of the second factors, V+ less V-
    int whole = 0;  ///< that of the source's own, as if there were no screens
  };
  std::vector<Part> parts;
};

/// All such segments, with the parts of the receiver from which they are one.
/// Maths     the sides of source and screens, cut where sides of polygons in a plane with them cross. Of a
///           piece that runs within a screen both sides are hidden; outside the source, in its plane, nothing
///           is seen. Its faces are the polygons of which it is a part of the border: as P passes the plane
///           of one, this changes from the one side of the piece to the other
/// Requires  convex polygons, receiver and source wholly in front of each other's planes and the screens
///           between these, points of the planes allowed; no screen in either plane
/// Result    exact; each segment once. Edges in the receiver's plane are left out: a screen's, for above them
///           is the screen and below them nothing, and the source's where no screen has a side in that plane,
///           for they are seen whole. Where one has, no value
[[nodiscard]] std::optional<std::vector<ContourEdge>> contour_edges(const ExactCorners& receiver,
                                                                    const ExactCorners& source,
                                                                    const std::vector<ExactCorners>& screens);

/// normal . X + constant, exactly: 0 on the plane of a polygon, positive in front of it.
struct ExactPlane {
  explicit ExactPlane(const ExactCorners& polygon);
  [[nodiscard]] Rational height(const Vector<Rational>& p) const { return dot(normal, p) + constant; }
  Vector<Rational> normal;
  Rational constant;
};

}  // namespace radcert
