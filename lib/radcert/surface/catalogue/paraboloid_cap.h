// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/exact_chart.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A quarter of the paraboloid over the unit disk.
/// Maths     F(s,t) = (+-x, +-y, 1 - x^2 - y^2),  (x,y) = disk_point(s,t)
/// Source    see disk_point
/// Requires  -
/// Result    see ChartOf
/// Limits    -
template <Field R>
class ParaboloidQuadrant {
public:
  explicit ParaboloidQuadrant(const Quadrant& quadrant) : x_(quadrant.x), y_(quadrant.y) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const DiskPoint<T> point = disk_point<R>(s, t);
    return {x_ * point.x, y_ * point.y, point.rest};
  }

private:
  R x_;
  R y_;
};

/// The boundary of the body between a paraboloid and its disk.
/// Maths     0 <= z <= 1 - x^2 - y^2
/// Source    -
/// Requires  -
/// Result    pieces floor (z = 0) and cap, four charts each
/// Limits    -
inline Surface paraboloid_cap() {
  Surface surface;
  surface.name = "paraboloid_cap";
  surface.charts = disk_charts("floor", 1, 0, Facing::up);
  const ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 0}, .linear = {{0, 0, 1}, -1}},
                                 .revolution = z_axis()};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points upwards
    surface.charts.push_back(make_exact_chart<ParaboloidQuadrant>(
        {.name = "cap/" + quadrant.name(),
         .piece = "cap",
         .domain = ChartDomain::unit_triangle,
         .orientation = quadrant.is_right_handed() ? Orientation::against_the_cross_product
                                                   : Orientation::along_the_cross_product,
         .structure = structure},
        quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

}  // namespace radcert
