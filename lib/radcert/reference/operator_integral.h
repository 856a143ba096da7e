// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "radcert/expression/expression.h"
#include "radcert/reference/density.h"
#include "radcert/reference/density_cells.h"
#include "radcert/scalar/approximation.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_function.h"
#include "radcert/surface/surface_point.h"

namespace radcert::reference {

/// The integral operator of the radiosity equation without its factor rho/pi, applied to one density, by
/// adaptive Gauss cubature over whole charts. Beside the collocation matrix it is the second route to Ku: it
/// knows no triangulation, no basis and nothing of the layer `quadrature`.
/// Maths     P -> Int_S G(P,Q) u(Q) dS_Q; about the point nearest to P in polar coordinates of its tangent
///           plane, r = delta sinh(x), tan(angle) = sinh(y), far from P over the parameter domain itself; s =
///           z^4 at a singular line
/// Source    the "alternative numerical integration method" that [ac98, section 5] asks for; the rule is
///           ours, the substitution by sinh is that of Johnston and Elliott 2005
/// Requires  P off every edge at which two charts meet at an angle, a surface that is `unoccluded` or a mesh,
///           u finite, else ContractViolation; u smooth on each chart; the surface outlives this. On an
///           occluded mesh the integral is that of G V u, over the parts that P sees
/// Result    an estimate: the radius is what the adaptive rule estimates of itself and a bound, to first
///           order, for the rounding of points and of G; the rounding of u counts as a few units in its last
///           place. About 1e-13 of Int G |u| where double allows: at any distance from an edge of flat pieces
///           and from a smooth seam (there up to 1e-12). The same bits on any number of threads, which may
///           share it
/// Limits    estimates, no proof: what a density does between the samples is not known. Where its formulas
///           are given too, the charts are cut until it is nearly a polynomial on every part, and what is
///           left of that joins the radius, see density_cells. A flat chart has the doubles nearest to its
///           coefficients. Where a curved piece meets another at an angle the radius grows like u |P| /
///           distance. A u that is not smooth costs time, bounded, and is seen in the radius. Keeps u and
///           points of each chart for the P far from it: 15 kB a chart, or more within 32 MB.
///           AccuracyNotReached on a curved closed surface a hundred times as wide as thick where Int G is
///           not pi within its radius
class AppliedOperator {
public:
  AppliedOperator(const Surface& surface, Density u);
  /// `formulas` are those of u on each chart.
  AppliedOperator(const Surface& surface, Density u, std::span<const Expression> formulas);
  /// u given by expressions alone; it outlives this.
  AppliedOperator(const Surface& surface, const SurfaceFunction& u);
  Approximation operator()(const SurfacePoint<double>& p) const;

private:
  struct Prepared;
  AppliedOperator(const Surface& surface, Density u, std::vector<DensityCell> cells, bool must_close);
  std::shared_ptr<const Prepared> prepared_;
};

/// The second route to Ku, for those who take one from outside (study.h).
[[nodiscard]] inline AppliedOperator applied_operator(const Surface& surface, const SurfaceFunction& u) {
  return {surface, u};
}

/// The same at one point, with nothing prepared.
/// Maths     Int_S G(P,Q) u(Q) dS_Q
/// Source    as above
/// Requires  as above
/// Result    as above, but that the value may differ from the other in rounding
/// Limits    as above
Approximation operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u);

/// The same over one triangle of one chart's parameter plane, for densities that are smooth on triangles
/// only.
/// Maths     Int over F_j(triangle) of G(P,Q) u(Q) dS_Q
/// Source    as above
/// Requires  as above, the surface `unoccluded`, the triangle inside the domain of the chart
/// Result    as above
/// Limits    as above
Approximation operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                                const std::array<ParameterPoint<double>, 3>& triangle, const Density& u);

}  // namespace radcert::reference
