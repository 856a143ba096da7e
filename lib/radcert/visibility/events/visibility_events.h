// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// How many pencils of lines are looked at: through a vertex or another point of a face's plane, and an edge.
extern const WorkLimit most_event_pencils;

/// Which light is asked about, and where it arrives; one entry a triangle of the scene.
struct EventQuestion {
  /// The number of the source that the triangle belongs to. Where neighbours have one number and one plane,
  /// the side between them is no border.
  std::vector<std::optional<std::size_t>> source;
  std::vector<bool> receives;  ///< whether its events are wanted
};

/// A segment on a triangle across which light is not smooth.
struct EventSegment {
  std::size_t triangle = 0;
  ParameterPoint<Rational> from;  ///< (s,t) is c_0 + s (c_1 - c_0) + t (c_2 - c_0), c the scene's corners
  ParameterPoint<Rational> to;
  int derivative = 2;  ///< the lowest that may jump across it: 1 or 2

  friend bool operator==(const EventSegment& a, const EventSegment& b) = default;
};

/// All events of a question.
struct VisibilityEvents {
  std::vector<EventSegment> segments;  ///< by triangle; those of one line do not overlap
  std::size_t pencils = 0;             ///< of lines, that were looked at
};

/// The vertex-edge events of sources, exactly.
/// Maths     I(x) = Int_{S(x)} g(x,s) ds, the light that a source S sends to points x of a plane face, g
///           smooth and positive, S(x) the part that x sees. S(x) is a polygon. Its sides lie on sides of S,
///           or are projections of edges from x; its corners are vertices of S, projections of vertices, or
///           points where projections of two edges meet. While no corner meets a side that it does not
///           belong to, corners depend smoothly on x, and so does I. An event is a set of x where one does.
///           With d the distance of x from it,
///           (1) a vertex v and an edge e, x on the plane through both, on a line that touches v and e and
///           begins on S (v or e may be the source's own): what the corner at v and the side of e cut off is
///           a triangle whose sides are proportional to d, on one side of the plane alone. I is changed by
///           c d^2 + O(d^3): I is continuously differentiable, its second derivative jumps.
///           (2) the same where an edge f through v lies in the plane as well: what is cut off is a strip of
///           the length that f and e have in common as seen from x, and the width d. I is changed by c d: its
///           first derivative jumps. Edges that are parallel make such planes, and so does the plane of a
///           face, whose edges take turns at bounding what is seen; that of the source's own face is one.
///           (3) three edges of which no two lie in one plane: x on the ruled quadric of the lines that touch
///           all three, a conic on the face. Again a triangle with sides proportional to d: the second
///           derivative jumps.
///           Where e ends on the face, d must be small against the distance r from there: the strip has the
///           width d/r, and at the end of e itself I has a limit in each direction, but none altogether.
///           Where e lies in the face, bodies that stand on it, I jumps across e itself, which is then a side
///           of the face
/// Source    (1)-(3) are derived as said; that vertex-edge planes and quadrics of edges are all events, and
///           the names: Heckbert, Discontinuity meshing for radiosity, 1992; Lischinski, Tampieri and
///           Greenberg, Discontinuity meshing for accurate radiosity, 1992
/// Requires  a scene without faults, which is closed: each side of a triangle is one of another that runs the
///           other way; one entry a triangle, else ContractViolation
/// Result    exact: (1) and (2), each cut to where a line from the source over v and e arrives, seen from the
///           front and with nothing between. A line may touch more than v and e on its way. In the plane of a
///           face a point x is on an event if a line that touches the face leads to a source; of these lines
///           those that can be turned no further pass a vertex or the place where an edge crosses the plane,
///           so that the pencils through these points find all. Refused: more than most_event_pencils
/// Limits    not (3): degrees of u_n above 1 find second derivatives that jump along its conics. What
///           reflected light adds depends on what is called a source
[[nodiscard]] Outcome<VisibilityEvents> visibility_events(const Scene& scene, const EventQuestion& question);

}  // namespace radcert
