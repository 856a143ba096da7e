// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "radcert/geometry/vector.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The signs of the three coordinates in an octant.
struct Octant {
  int x;
  int y;
  int z;
};

/// One eighth of an ellipsoid, the radial image of a face of the octahedron.
/// Maths     F(s,t) = diag(a,b,c) e/|e|,  e = (+-(1-s-t), +-s, +-t)
/// Source    ours; analytic on the closed triangle, as charts by sqrt(1-x^2-y^2) or polar angles are not
/// Requires  a, b, c > 0
/// Result    see ChartOf
template <Field R>
class EllipsoidOctant {
public:
  EllipsoidOctant(const Rational& a, const Rational& b, const Rational& c, const Octant& octant)
      : a_(from_rational<R>(octant.x * a)),
        b_(from_rational<R>(octant.y * b)),
        c_(from_rational<R>(octant.z * c)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const T u = R(1) - (s + t);
    using std::sqrt;
    const T inverse_length = reciprocal(sqrt(u * u + s * s + t * t));
    return {a_ * (u * inverse_length), b_ * (s * inverse_length), c_ * (t * inverse_length)};
  }

private:
  R a_;
  R b_;
  R c_;
};

/// An ellipsoid with centre 0 and half axes a, b, c, by eight charts over the faces of the octahedron.
/// Maths     (x/a)^2 + (y/b)^2 + (z/c)^2 = 1
/// Source    n = 8, 32, 128, ... as in [ac98, section 3]
/// Requires  a, b, c > 0, else ContractViolation
/// Result    one smooth piece `ellipsoid`, inner normals
Surface ellipsoid(const Rational& a, const Rational& b, const Rational& c);

/// The half axes of a chart that is such an octant, with their signs.
/// Maths     F(s,t) = diag(x,y,z) e/|e|, e = (1-s-t, s, t)
/// Result    enclosed; nothing for a chart whose formula in balls is not EllipsoidOctant
std::optional<Vector<Ball>> octant_axes(const Chart& chart);

/// The unit sphere, by the same eight charts.
/// Maths     x^2 + y^2 + z^2 = 1
/// Source    G = 1/4 on it: [m06, Lemma 1 (d)]
/// Result    one smooth piece `sphere`, inner normals
Surface sphere();

}  // namespace radcert
