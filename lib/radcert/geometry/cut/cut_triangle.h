// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/cut/segment_arrangement.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// How many segments one triangle is cut along.
extern const WorkLimit most_segments_of_a_cut;

/// The binary digits that a corner of a cut triangle has behind the point.
inline constexpr int digits_of_a_cut = 30;

/// The height below which a part is refused.
inline constexpr double least_height_of_a_cut = 0x1p-20;

/// The unit triangle, cut along segments.
/// Maths     constrained Delaunay triangulation of (0,0), (1,0), (0,1) and the arrangement of the segments,
///           each of whose points is moved to the nearest multiple of 2^-digits_of_a_cut in both coordinates:
///           of the triangulations with these vertices and segments the one whose least angles are largest
/// Source    CGAL, exact predicates; the arrangement is exact before its points are moved
/// Requires  segments of a length within the closed unit triangle, else ContractViolation
/// Result    a conforming triangulation of the unit triangle, as [m06, T1-T3] ask, counterclockwise. Its
///           corners are exact dyadic numbers: the midpoints of 22 refinements are doubles. A line through
///           moved points is off by at most 2^-31 in each coordinate. A point on a side stays on it, and the
///           same whichever end the side is measured from, so that neighbours are cut at the same points.
///           Points nearer to each other than that become one, as those of lines do that rounded coordinates
///           keep from being one. Refused: more segments than most_segments_of_a_cut; a part of a height
///           below least_height_of_a_cut; points whose move makes segments cross
/// Limits    no vertex is added, so that angles are as small as segments make them
[[nodiscard]] Outcome<std::vector<std::array<ParameterPoint<double>, 3>>> cut_triangle(
    std::span<const PlaneSegment> segments);

}  // namespace radcert
