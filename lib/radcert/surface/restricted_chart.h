// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "radcert/geometry/polygon_triangulation.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// A part of a chart, over a triangle of its parameter plane, as a chart over the unit triangle.
/// Maths     (s,t) -> F(v_1 + s (v_2 - v_1) + t (v_3 - v_1)) in every arithmetic that F has
/// Source    [m06, (12)]: the map of the unit triangle onto a triangle of R_j
/// Requires  v_1, v_2, v_3 counterclockwise and in the chart's domain; no singular line within the chart, else ContractViolation
/// Result    as the chart; tangents, area normals and chords by the chain rule. The piece, the plane, the quadric and the axis stay; a
///           ruling along t does not
/// Limits    parameters are rounded once more
[[nodiscard]] Chart restricted_chart(const Chart& chart,
                                     const std::array<ParameterPoint<Rational>, 3>& triangle,
                                     const std::string& name);

/// The parts of a chart over the triangles of a polygon, so that any simple polygon, with holes or without, may be an R_j.
/// Maths     S_j = F_j(R_j), R_j the union of the triangles
/// Source    [ac98, (13)-(14)]; a polygon's triangles: triangulate, graded_toward
/// Requires  as restricted_chart
/// Result    charts of one piece that join smoothly, named name/0, name/1, ...; conforming where the triangulation is
/// Limits    -
[[nodiscard]] std::vector<Chart> charts_over(const Chart& chart, const PlaneTriangulation& domain);

}  // namespace radcert
