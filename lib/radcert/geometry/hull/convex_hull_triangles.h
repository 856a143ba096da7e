// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The boundary of the convex hull of points in space, in triangles.
/// Source    CGAL's convex_hull_3, exact arithmetic
/// Requires  nothing
/// Result    exact; corners run counterclockwise as seen from the inside; none where all points lie in one
///           plane
[[nodiscard]] std::vector<std::array<Vector<Rational>, 3>> convex_hull_triangles(
    std::span<const Vector<Rational>> points);

}  // namespace radcert
