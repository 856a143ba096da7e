// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert::reference {

/// A density u on a surface: its value at a point, given both by its parameters and by its coordinates.
using Density = std::function<double(const SurfacePoint<double>& q, const Vector<double>& point)>;

/// A number with an estimate of its error. Not a guarantee: `radius` comes from the adaptive rule's own comparison.
struct Estimate {
  double value = 0;
  double radius = 0;
  double absolute = 0;  ///< the same integral of the absolute value of the integrand
};

/// The integral operator of the radiosity equation without its factor rho/pi, by adaptive Gauss-Kronrod cubature over
/// whole charts. Beside the collocation matrix it is the second route to Ku: it knows no triangulation, no basis and
/// nothing of the layer `quadrature`.
/// Maths     Int_S G(P,Q) u(Q) dS_Q
/// Source    the "alternative numerical integration method" that [ac98, section 5] asks for; the rule is ours
/// Requires  P off every edge at which two pieces meet at an angle; u smooth on each chart; an unoccluded surface
/// Result    value, with a radius of about 1e-13 of `absolute` where double allows
/// Limits    estimates, no proof; cost grows with the logarithm of the distance of P from an edge
Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u);

/// The same over one triangle of one chart's parameter plane, for densities that are smooth on triangles only.
/// Maths     Int over F_j(triangle) of G(P,Q) u(Q) dS_Q
/// Source    as above
/// Requires  as above, the triangle inside the domain of the chart
/// Result    as above
/// Limits    as above
Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                           const std::array<ParameterPoint<double>, 3>& triangle, const Density& u);

}  // namespace radcert::reference
