// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/geometry/vector.h"

namespace radcert {

/// A point of a surface, by its chart and its parameters there.
/// Maths     P = F_j(s, t)
/// Source    [ac98, (14)]
/// Requires  chart < surface.chart_count(), (s,t) in the chart's domain
/// Result    the parameters are exact: P is the image of these very doubles
/// Limits    a point on a seam has one such name a chart
template <Field R>
struct SurfacePoint {
  std::size_t chart = 0;
  ParameterPoint<R> at;
};

}  // namespace radcert
