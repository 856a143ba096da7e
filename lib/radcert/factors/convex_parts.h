// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/factors/exchange_area.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// A convex polygon that triangles of one plane make up.
struct ConvexPart {
  FacetCorners corners;      ///< counterclockwise as seen from the front, no three in a row on a line
  std::size_t triangle = 0;  ///< one of its own
};

/// Triangles of one plane, joined along their common sides while their union stays convex.
/// Requires  one triangle or more, all of one oriented plane
/// Result    exact: a partition of the triangles; all together where their union is convex
/// Limits    not the fewest parts: neighbours are joined in the order in which they come
[[nodiscard]] std::vector<ConvexPart> convex_parts(const Scene& scene,
                                                   const std::vector<std::size_t>& triangles);

}  // namespace radcert
