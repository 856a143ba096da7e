// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/reference/cubature/adaptive_cubature.h"
#include "radcert/reference/cubature/kernel_integrands.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/polygon.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert::reference {

/// The point P at which the operator is applied, and the density that it is applied to.
/// Maths     P = F_j(p.at), its frame and n_P; the density u
/// Source    [ac98, (2)]
/// Requires  a surface and a density that outlive this
/// Result    holds what it is given
struct OperatorPoint {
  const Surface* surface;
  SurfacePoint<double> p;
  Frame<double> frame;
  Vector<double> normal;
  const Density* density;
};

/// The integral of G u over a polygon of one chart, decomposed about the point nearest to P and added to a
/// cubature.
/// Maths     Int over F_index(polygon) of G(P,Q) u(Q) dS_Q; nothing where P and the chart lie in one plane,
///           where G = 0
/// Source    ours
/// Requires  P off the edge where its piece meets another, else ContractViolation; the polygon in the domain
///           of the chart
/// Result    sectors about the nearest point, or triangles or slabs where that is far; slabs graded towards a
///           singular line
/// Limits    across a smooth seam a disk of radius 3e-9 of the extent about P is bounded instead of
///           integrated
void add_part(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index, const Polygon& polygon);

/// G J on another chart than P's, its parameters counted from an apex.
/// Maths     w -> G(P, F_index(apex + w)) J
/// Source    [ac98, (2)]
/// Requires  index != p.chart
/// Result    of the chart's own kind; between flat charts the offset F(apex) - P is rounded once
Integrand other_integrand(const OperatorPoint& at, std::size_t index, const Parameters& apex);

}  // namespace radcert::reference
