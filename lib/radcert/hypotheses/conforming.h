// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "radcert/core/outcome.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert {

/// A triangle of the parameter plane by its corners.
using DomainTriangle = std::array<ParameterPoint<Rational>, 3>;

/// Whether triangles are a conforming triangulation of a parameter domain.
/// Maths     T1: the polygon's vertices are vertices of triangles. T2: its sides are unions of triangles'
///           sides. T3: two triangles meet in nothing, in a common vertex or in a common side. And they cover
///           the polygon
/// Source    [m06, T1-T3]. All triangles run counterclockwise; each side lies once each way, or once and then
///           along the border; these border sides make up each side of the loops once. Then the triangles'
///           borders add up to the polygon's, every point inside is covered as often as the border winds
///           around it, once, and no vertex lies within another's side
/// Requires  loops as those of a PlanePolygon: the first counterclockwise, the holes clockwise
/// Result    exact, in n log n steps; else what is wrong and where: "triangle 3 is clockwise or flat", ...
/// Limits    within one domain: says nothing of how domains meet across a seam
[[nodiscard]] Outcome<void> conforming(std::span<const PolygonLoop> loops,
                                       std::span<const DomainTriangle> triangles);

}  // namespace radcert
