// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/surface/chart.h"

namespace radcert::reference {

/// A point of a chart's parameter plane.
using Parameters = ParameterPoint<double>;

/// A convex polygon of the parameter plane.
/// Maths     the convex hull of vertex[0 .. count-1], counterclockwise; operator[] counts them round and
///           round
/// Requires  at most eight vertices
/// Result    holds what it is given
/// Limits    convexity and orientation are the caller's
struct Polygon {
  std::array<Parameters, 8> vertex{};
  std::size_t count = 0;

  void add(const Parameters& v) { vertex[count++] = v; }
  const Parameters& operator[](std::size_t i) const { return vertex[i % count]; }
};

/// The domain of a chart, a triangle with its corners in either order, and the part of a polygon on one side
/// of a line.
/// Maths     R_j;  the triangle, counterclockwise;  {x in the polygon : sign (normal . x - cut) >= 0}
/// Requires  sign 1 or -1; a normal other than 0; no more than eight vertices after the cut
/// Result    a polygon, on both sides of a cut with the same vertices there, rounded, where the normal is
///           (1,0) in t alone; count = 0 where fewer than three are left
Polygon whole_domain(ChartDomain domain);
Polygon counterclockwise(const std::array<Parameters, 3>& triangle);
Polygon clipped(const Polygon& polygon, const Parameters& normal, double cut, double sign);

}  // namespace radcert::reference
