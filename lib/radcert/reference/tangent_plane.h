// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/geometry/vector.h"
#include "radcert/reference/polygon.h"

namespace radcert::reference {

/// Coordinates in a tangent plane of a chart in which distances are those of space.
/// Maths     x = A w, |A w| = |D_s F w_s + D_t F w_t|, A upper triangular
/// Source    Gram-Schmidt
/// Requires  tangents that are linearly independent
/// Result    coordinates, parameters (A^-1) and the projection of a vector of space, rounded; determinant() =
///           det A
/// Limits    digits are lost as the tangents become parallel
struct TangentPlane {
  Vector<double> first;  // orthonormal
  Vector<double> second;
  double ss;
  double st;
  double tt;

  TangentPlane(const Vector<double>& tangent_s, const Vector<double>& tangent_t) {
    ss = norm(tangent_s);
    first = (1 / ss) * tangent_s;
    st = dot(first, tangent_t);
    const Vector<double> rest = tangent_t - st * first;
    tt = norm(rest);
    second = (1 / tt) * rest;
  }
  Parameters coordinates(const Parameters& w) const { return {ss * w.s + st * w.t, tt * w.t}; }
  Parameters parameters(const Parameters& x) const {
    const double t = x.t / tt;
    return {(x.s - st * t) / ss, t};
  }
  Parameters projection(const Vector<double>& x) const { return {dot(first, x), dot(second, x)}; }
  double determinant() const { return ss * tt; }
};

/// Length and inner product of two coordinates in a tangent plane.
inline double length(const Parameters& x) { return std::hypot(x.s, x.t); }
inline double inner(const Parameters& x, const Parameters& y) { return x.s * y.s + x.t * y.t; }

}  // namespace radcert::reference
