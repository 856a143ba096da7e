// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A quarter of the mantle of a truncated cone about the z-axis.
/// Maths     F(s,t) = (+-r(t) x, +-r(t) y, h t),  (x,y) = arc_point(s),  r(t) = radius + (top - radius) t
/// Source    see arc_point
/// Requires  radius, top, h > 0
/// Result    see ChartOf; straight in t
/// Limits    a chart up to an apex, top = 0, would have vanishing area normals there: no chart of a cone is
///           smooth at its apex
template <Field R>
class ConeMantle {
public:
  ConeMantle(const Rational& radius, const Rational& top, const Rational& height, const Quadrant& quadrant)
      : radius_(from_rational<R>(radius)),
        growth_(from_rational<R>(top - radius)),
        height_(from_rational<R>(height)),
        x_(quadrant.x),
        y_(quadrant.y) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const ArcPoint<T> arc = arc_point<R>(s);
    const T radius = radius_ + growth_ * t;
    return {x_ * (radius * arc.x), y_ * (radius * arc.y), height_ * t};
  }

private:
  R radius_;
  R growth_;
  R height_;
  R x_;
  R y_;
};

/// The boundary of a truncated cone: two disks and the mantle between them.
/// Maths     sqrt(x^2 + y^2) <= radius + (top - radius) z/height,  0 <= z <= height
/// Requires  radius, top, height > 0, else ContractViolation
/// Result    pieces floor, ceiling (z = 0, height) and mantle, four charts each
/// Limits    truncated: at an apex the surface has no normal, so that it is no corner of smooth pieces in the
///           sense of [ac98, (13)-(14)], which the quadrature and every statement on orders assume
Surface cone(const Rational& radius, const Rational& top, const Rational& height);

}  // namespace radcert
