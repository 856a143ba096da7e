// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/geometry/plane_polygon.h"

namespace radcert {

/// The convex hull of points of the parameter plane.
/// Source    CGAL's convex_hull_2, exact arithmetic
/// Requires  at least three points, not all on one line
/// Result    its vertices counterclockwise, no three of them on a line; exact
[[nodiscard]] PolygonLoop convex_hull(std::span<const ParameterPoint<Rational>> points);

/// The area of a polygon of the parameter plane, positive where it runs counterclockwise; exact.
[[nodiscard]] Rational signed_area(std::span<const ParameterPoint<Rational>> loop);

}  // namespace radcert
