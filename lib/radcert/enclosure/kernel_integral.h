// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "radcert/enclosure/exact_observer.h"
#include "radcert/enclosure/polygon_integral.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A point Q of a surface as a density sees it.
/// Maths     Q = F_chart(s, t), at = (s, t)
/// Source    [ac98, (14)]
template <Real R>
struct DensityPoint {
  std::size_t chart;
  ParameterPoint<R> at;
  Vector<R> point;
};

/// The factor q beside the kernel, in balls, in Taylor models and in doubles with bounds.
/// Maths     q(Q); see SquareFunction
/// Requires  analytic in the parameters, or at least bounded (then the integral costs more): the formula says
///           which
/// Result    made from a formula by density(f): a class with  template <class R> R operator()(const
///           DensityPoint<R>& q) const; or a generic lambda
struct DensityFormula {
  std::function<Ball(const DensityPoint<Ball>&)> in_balls;
  std::function<TaylorModel(const DensityPoint<TaylorModel>&)> in_models;
  std::function<BoundedDouble(const DensityPoint<BoundedDouble>&)> in_doubles;
};
template <class Formula>
DensityFormula density(Formula formula) {
  return {
      .in_balls = [formula](const DensityPoint<Ball>& q) -> Ball { return formula(q); },
      .in_models = [formula](const DensityPoint<TaylorModel>& q) -> TaylorModel { return formula(q); },
      .in_doubles = [formula](const DensityPoint<BoundedDouble>& q) -> BoundedDouble { return formula(q); }};
}
/// q = 1.
[[nodiscard]] DensityFormula unit_density();

/// The radiosity operator's integral over a part of one chart, enclosed.
/// Maths     Int G(P, F(s,t)) q(s,t) |D_s F x D_t F| ds dt over a convex polygon of the chart's domain
/// Source    integral_over_squares, from triangles with a common apex: P itself where P is a point of the
///           polygon, and with Q - P = x D(x, y) along the rays from P the kernel is chord_kernel of
///           Chart::chord_along, analytic in (x, y) up to x = 0; otherwise the parameters of a point near to
///           P where P is close to the chart. G is linear in the normal n_Q: with the area normal no root is
///           needed for the area element
/// Requires  a polygon in the domain with an area; a name of P in the domain of its chart, else
///           ContractViolation. V = 1 between P and the part
/// Result    see integral_over_squares. Exactly 0 where P lies in the plane of a flat chart
/// Limits    P on the chart and not named there, or named and at the border of a polygon that does not
///           contain it: the singularity is bisected until the work limit. On a chart that is not analytic on
///           the line s = 0 (its facts say so) the work grows with the number of digits times the logarithm
///           of the demand, and P with s = 0 is refused as undecided
[[nodiscard]] Enclosure kernel_integral(const ExactObserver& observer, const Surface& surface,
                                        std::size_t chart, const ParameterPolygon& polygon,
                                        const DensityFormula& q, const Demand& demand);

/// The same over the whole surface.
/// Maths     Int_S G(P,Q) q(Q) dS_Q, the sum over the charts
/// Source    [ac98, (1)-(2)] with V = 1
/// Requires  the surface unoccluded from P
/// Result    see kernel_integral; the demand is for the sum
/// Limits    see kernel_integral
[[nodiscard]] Enclosure kernel_integral(const ExactObserver& observer, const Surface& surface,
                                        const DensityFormula& q, const Demand& demand);

/// The domain of a chart as a polygon.
[[nodiscard]] ParameterPolygon domain_polygon(const Chart& chart);

}  // namespace radcert
