// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/reference/chart_parts.h"
#include "radcert/reference/density_cells.h"
#include "radcert/visibility/surface_scene.h"

namespace radcert::reference {

/// The integral of G u over what P sees of a plane chart, added to a cubature.
/// Maths     Int over the parts, cut along the borders of the chart's cells, of G(P,Q) u(Q) dS_Q, as add_part
/// Source    ours
/// Requires  as add_part; view.sight is part, and the view that from P; cells that cover the chart
/// Result    what the rounding of corners may change, strip_bound times the largest |u| at them, counts as an
///           integral that is left out
void add_visible_parts(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index,
                       const ChartView& view, std::span<const DensityCell> cells);

}  // namespace radcert::reference
