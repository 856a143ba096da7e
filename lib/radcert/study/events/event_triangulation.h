// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "radcert/study/events/event_cut.h"
#include "radcert/study/problem.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The coarse triangulation of `"events"`.
/// Maths     the events of the pieces with E not identically 0, on the pieces with rho not identically 0,
///           where alone light that arrives adds to u. With `secondary` = c the pieces on which rho/(1 - max
///           rho) exceeds c count as sources too: there |u - E| <= rho max|u| <= rho/(1 - max rho) max|E|, as
///           form factors are at most 1. Pieces with the same formulas are one source
/// Source    visibility_events, cut_triangle
/// Requires  the problem's surface
/// Result    or InputError at /triangulation/events: a solution in place of an emission, a meshless basis,
///           interpolated geometry, a grading, curved charts, a surface whose parts hide nothing, one that is
///           not closed, a chart that is refused by cut_triangle
/// Limits    a reflectivity that is no constant counts as up to 1
[[nodiscard]] EventCut event_cut(const Problem& problem, const Surface& surface,
                                 const std::optional<Rational>& secondary = std::nullopt);

/// What a problem says of a surface's triangulations, for triangulate and triangle_count.
[[nodiscard]] TriangulationOptions triangulation_options(const Problem& problem, const Surface& surface);

}  // namespace radcert
