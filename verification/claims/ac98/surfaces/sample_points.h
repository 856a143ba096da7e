// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert::verification::ac98 {

/// Collocation nodes of the inset basis, degree 1.
/// Maths     m_k(q_j) of [ac98, (33)-(36)]
/// Source    [ac98, section 3.1]
/// Requires  0 < inset < 1/3
/// Result    element by element, at the given level of the surface's own triangulation
[[nodiscard]] std::vector<SurfacePoint<double>> collocation_points(const Surface& surface, int level,
                                                                   const Rational& inset);

/// Points inside the charts.
/// Maths     uniform in the parameters, at least 1/100 from the border of each chart's domain; every third
///           within 1/20 of a side
/// Source    std::mt19937_64 with our own mapping
/// Requires  nothing
/// Result    the same for the same seed; `per_chart` of each chart
/// Limits    not uniform on the surface
[[nodiscard]] std::vector<SurfacePoint<double>> random_points(const Surface& surface, std::size_t per_chart,
                                                              std::uint64_t seed);

/// A point of the unit sphere with rational coordinates.
/// Maths     (2u, 2v, 1 - u^2 - v^2)/(1 + u^2 + v^2)
/// Source    stereographic projection from (0,0,-1)
/// Result    exact
[[nodiscard]] Vector<Rational> sphere_point(const Rational& u, const Rational& v);

}  // namespace radcert::verification::ac98
