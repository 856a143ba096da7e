// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/reference/polygon.h"
#include "radcert/reference/tangent_plane.h"
#include "radcert/surface/chart.h"

namespace radcert::reference {

/// The point of a segment from + l (to - from), 0 <= l <= 1, and the point of a polygon nearest to a target.
/// Maths     the minimiser of |A (x - centre) - target|, A that of `plane`
/// Requires  a polygon with count > 0
/// Result    a point of the segment or polygon, up to rounding; the ends of a segment exactly
Parameters nearest_on_side(const Parameters& from, const Parameters& to, const Parameters& centre,
                           const Parameters& target, const TangentPlane& plane);
Parameters nearest_in_polygon(const Polygon& polygon, const Parameters& centre, const Parameters& target,
                              const TangentPlane& plane);

/// A point of the polygon about as near to P as any.
/// Maths     argmin |F(x) - P| by damped Gauss-Newton, each step the nearest point of the polygon in the
///           tangent plane
/// Requires  a polygon with count > 0
/// Result    a point of the polygon up to rounding; AccuracyNotReached where the steps do not end and a point
///           may be four times as near
/// Limits    may end in a local minimum. It is the apex of a decomposition: any point gives the right
///           integral, this one gives it cheaply, and shows the points of a rule where the kernel has its
///           peak
Parameters nearest_to(const Vector<double>& p, const ChartIn<double>& chart, const Polygon& polygon);

/// The greatest distance of a vertex from the apex, and the apex moved onto a corner or a side that is near
/// enough.
/// Maths     max |A (v_i - apex)|;  a corner within 1.4 reach, else the foot on a side within reach, else the
///           apex
/// Requires  a polygon with count > 0
/// Result    rounded; an apex that stays is farther than `reach` from every side
/// Limits    distances are those of `plane`
double radius_of(const Polygon& polygon, const Parameters& apex, const TangentPlane& plane);
Parameters snapped(const Parameters& apex, const Polygon& polygon, const TangentPlane& plane, double reach);

}  // namespace radcert::reference
