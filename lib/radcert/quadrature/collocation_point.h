// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert {

/// The point P from which a row of the collocation matrix looks at the surface.
/// Maths     P = F_j(s,t) and the unit inner normal n_P
/// Source    the v_i of [ac98, (40)]
/// Requires  see SurfacePoint
/// Result    rounded as R rounds
template <Real R>
struct CollocationPoint {
  SurfacePoint<R> at;
  Vector<R> point;
  Vector<R> normal;
};

/// The point of a surface at a place, with its unit inner normal. Result as CollocationPoint.
template <Real R>
CollocationPoint<R> collocation_point(const Surface& surface, const SurfacePoint<R>& at) {
  const Chart& chart = surface.charts[at.chart];
  const Frame<R> frame = chart.in<R>().frame(at.at);
  return {at, frame.point, unit_normal(frame)};
}

}  // namespace radcert
