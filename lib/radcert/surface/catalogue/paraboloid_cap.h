// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A quarter of the paraboloid over the unit disk.
/// Maths     F(s,t) = (+-x, +-y, 1 - x^2 - y^2),  (x,y) = disk_point(s,t)
/// Source    see disk_point
/// Result    see ChartOf
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
/// Result    pieces floor (z = 0) and cap, four charts each
Surface paraboloid_cap();

}  // namespace radcert
