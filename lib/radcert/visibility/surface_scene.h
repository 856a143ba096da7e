// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/visibility/point_view.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// The part of a chart that a point sees, in the chart's parameters.
/// Maths     the union of the parts, convex polygons of the parameter plane whose interiors have no point in
///           common
/// Result    each part counterclockwise; its coordinates within 2^-51 of the exact ones and in the chart's
///           domain. whole: no part is listed
struct ChartView {
  Sight sight = Sight::nothing;
  std::vector<std::vector<ParameterPoint<double>>> parts;
};

/// A mesh surface as a scene whose points look at each other, chart by chart.
/// Maths     triangle k of the scene is chart k, its corners in the order in which the inner normal sees them
///           counterclockwise
/// Source    [ac98, (1)]: the V(P,Q) of the equation
/// Requires  a surface with a mesh, else ContractViolation
/// Result    immutable; shared by threads, each with its own PointView
/// Limits    curved charts are not looked at
class SurfaceScene {
public:
  explicit SurfaceScene(const Surface& surface);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// The view from a point of chart `chart`, both as the doubles that stand for them.
  [[nodiscard]] PointView view(std::size_t chart, const Vector<double>& point,
                               const Vector<double>& normal) const;
  [[nodiscard]] ChartView seen(PointView& view, std::size_t chart) const;
  /// A point of a triangle of the scene in the parameters of its chart.
  [[nodiscard]] ParameterPoint<Rational> on_chart(const ParameterPoint<Rational>& of_triangle) const {
    return exchanged_ ? ParameterPoint<Rational>{of_triangle.t, of_triangle.s} : of_triangle;
  }

private:
  bool exchanged_;  ///< s and t are those of the chart in the other order
  Scene scene_;
};

/// A bound of the error that the rounding of a part's corners causes in the integral of G over it.
/// Maths     sum over the sides of  w |side| h / distance^3,  w = 2^-50 (|D_s F| + |D_t F|) the width of a
///           strip beside a side of which no corner is off by more than that, h the height of P over the
///           chart's plane, at most the distance of P from the side: |G| <= h / |P-Q|^3
/// Requires  a plane chart and its frame anywhere; at least three corners
/// Result    bounds the integral of |G| over the strips to first order
[[nodiscard]] double strip_bound(const Vector<double>& p, const ChartIn<double>& chart,
                                 std::span<const ParameterPoint<double>> corners);

}  // namespace radcert
