// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/factors/facet_scene.h"

namespace radcert {

/// Lines beyond so many cells do not cut.
inline constexpr std::size_t most_receiver_cells = 256;

/// A receiver parted where what it sees of a source past occluders changes its kind.
/// Maths     the shadow of one convex body on the source gains or loses a side only where P lies in a plane
///           through a side of one and a corner of the other, in line with both and farther from the source
///           than the body, or in the plane of a face: along these lines the receiver is cut. A side between
///           two faces of a body counts for those corners of the source that one of them alone looks at; a
///           corner of a body for those sides of the source that not all of its faces look at, nor all away
///           from
/// Source    -
/// Requires  convex polygons, receiver and source wholly in front of each other's planes; occluders of the
///           scene, ascending
/// Result    convex polygons that cover the receiver and run as it does, rounded; lines within some roundings
///           of a corner do not cut. On each cell the flux past one body is analytic inside; past several it
///           is so but for curves where their shadows begin to meet, or a corner where sides of two meet
///           passes a side of the source
/// Limits    most_receiver_cells
[[nodiscard]] std::vector<FacetCorners> receiver_cells(const FacetScene& scene, const FacetCorners& receiver,
                                                       const FacetCorners& source,
                                                       const std::vector<std::size_t>& occluders);

}  // namespace radcert
