// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A quarter of a cap of the unit sphere, the equal-area image of the unit disk's.
/// Maths     F(s,t) = (+-2 sqrt(f) x w, +-2 sqrt(f) y w, 1 - 2f (x^2+y^2)),  w = sqrt(1 - f (x^2+y^2)),
///           (x,y) = disk_point(s,t); |D_s F x D_t F| = 4f/(1-2st)^2
/// Source    Lambert's equal-area projection
/// Requires  0 < f < 1
/// Result    see ChartOf
/// Limits    w vanishes at distance (1-f)/f outside the rim: for f near 1 orders are seen on fine
///           triangulations only
template <Field R>
class SphericalCapQuadrant {
public:
  SphericalCapQuadrant(const Rational& fraction, const Quadrant& quadrant)
      : fraction_(from_rational<R>(fraction)),
        rest_(from_rational<R>(1 - fraction)),
        rim_(from_rational<R>(1 - 2 * fraction)),
        diameter_(root_of(from_rational<R>(4 * fraction))),
        x_(quadrant.x),
        y_(quadrant.y) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    using std::sqrt;
    const DiskPoint<T> point = disk_point<R>(s, t);
    const T height = fraction_ * point.rest;  // f (1 - x^2 - y^2)
    const T across = diameter_ * sqrt(rest_ + height);
    return {x_ * (point.x * across), y_ * (point.y * across), rim_ + R(2) * height};
  }

private:
  static R root_of(const R& x) {
    using std::sqrt;
    return sqrt(x);
  }

  R fraction_;
  R rest_;      ///< 1 - f
  R rim_;       ///< the height of the rim
  R diameter_;  ///< 2 sqrt(f)
  R x_;
  R y_;
};

/// The cap of the unit sphere about its north pole that has a given part of its area.
/// Maths     x^2 + y^2 + z^2 = 1, z >= 1 - 2f; its area is 4 pi f
/// Source    G = 1/4 on the sphere, so that constant E and rho have u = E/(1 - rho f)
/// Requires  0 < fraction < 1, else ContractViolation
/// Result    one smooth piece `cap`, four charts, inner normals; f = 1/2 is the hemisphere
/// Limits    not closed: its rim is the circle z = 1 - 2f
Surface spherical_cap(const Rational& fraction);

}  // namespace radcert
