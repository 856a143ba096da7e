// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// A convex polygon of a chart's parameters, by its corners counterclockwise.
template <Field R>
using ConvexPolygon = std::vector<ParameterPoint<R>>;

/// A convex polygon's part to the left of the line from a to b.
/// Source    Sutherland and Hodgman, Reentrant polygon clipping, 1974
/// Result    for Rational exact, for double rounded
template <Field R>
[[nodiscard]] ConvexPolygon<R> left_of(const ParameterPoint<R>& a, const ParameterPoint<R>& b,
                                       const ConvexPolygon<R>& polygon) {
  const R zero(0);
  const ParameterPoint<R> along = b - a;
  ConvexPolygon<R> left;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ParameterPoint<R>& p = polygon[k];
    const ParameterPoint<R>& q = polygon[(k + 1) % polygon.size()];
    const R at_p = cross(along, p - a);
    const R at_q = cross(along, q - a);
    if (at_p >= zero) left.push_back(p);
    if ((at_p > zero && at_q < zero) || (at_p < zero && at_q > zero))
      left.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return left;
}

/// What a convex polygon has in common with another, by cutting it along the sides of the other.
/// Limits    of two corners of `sides` that are almost one, rounded doubles say nothing about the line
///           through them
template <Field R>
[[nodiscard]] ConvexPolygon<R> clipped(ConvexPolygon<R> polygon, std::span<const ParameterPoint<R>> sides) {
  for (std::size_t k = 0; k < sides.size() && polygon.size() >= 3; ++k)
    polygon = left_of(sides[k], sides[(k + 1) % sides.size()], polygon);
  return polygon;
}

/// Twice the area of a convex polygon, in the unit of its parameters squared.
/// Result    0 or more for corners counterclockwise; for Rational exact, for double rounded
template <Field R>
[[nodiscard]] R doubled_area(const ConvexPolygon<R>& polygon) {
  R area(0);
  for (std::size_t k = 2; k < polygon.size(); ++k)
    area += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return area;
}

}  // namespace radcert
