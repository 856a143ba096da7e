// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A sixteenth of a torus about the z-axis: a quarter around, a quarter of the tube.
/// Maths     F(s,t) = (+-(R +- r a) x, +-(R +- r a) y, +-r b),  (x,y) = arc_point(s), (a,b) = arc_point(t),
///           R = radius, r = ratio R
/// Source    see arc_point
/// Requires  radius > 0, 0 < ratio < 1
/// Result    see ChartOf
template <Field R>
class TorusPatch {
public:
  TorusPatch(const Rational& radius, const Rational& ratio, const Quadrant& around, const Quadrant& of_tube)
      : radius_(from_rational<R>(radius)),
        outwards_(from_rational<R>(of_tube.x * ratio * radius)),
        upwards_(from_rational<R>(of_tube.y * ratio * radius)),
        x_(around.x),
        y_(around.y) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const ArcPoint<T> arc = arc_point<R>(s);
    const ArcPoint<T> section = arc_point<R>(t);
    const T distance = radius_ + outwards_ * section.x;
    return {x_ * (distance * arc.x), y_ * (distance * arc.y), upwards_ * section.y};
  }

private:
  R radius_;
  R outwards_;
  R upwards_;
  R x_;
  R y_;
};

/// A torus about the z-axis.
/// Maths     (sqrt(x^2 + y^2) - R)^2 + z^2 = r^2,  R = radius, r = ratio R
/// Requires  radius > 0, 0 < ratio < 1, else ContractViolation
/// Result    one smooth piece `torus`, sixteen charts, inner normals (into the tube)
/// Limits    not convex: its parts hide each other, `unoccluded` is false
Surface torus(const Rational& radius, const Rational& ratio);

}  // namespace radcert
