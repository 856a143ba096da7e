// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/real.h"

namespace radcert {

/// A point or a vector of space, in any arithmetic.
/// Maths     a . b, a x b, |a|
/// Result    coordinates in the unit of the surface; rounded as R rounds
/// Limits    points and vectors are one type: the formulas of the papers subtract points freely
template <Field R>
struct Vector {
  R x{};
  R y{};
  R z{};

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
  friend Vector operator*(const R& c, const Vector& a) { return {c * a.x, c * a.y, c * a.z}; }
  friend bool operator==(const Vector& a, const Vector& b) = default;
};

/// a . b, rounded as R rounds.
template <Field R>
R dot(const Vector<R>& a, const Vector<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a x b, rounded as R rounds.
template <Field R>
Vector<R> cross(const Vector<R>& a, const Vector<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// |a|, rounded as R rounds.
template <Field R>
R norm(const Vector<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// A point of a chart's parameter plane, the (s, t) of [ac98, (14)].
template <Field R>
struct ParameterPoint {
  R s{};
  R t{};

  friend ParameterPoint operator+(const ParameterPoint& a, const ParameterPoint& b) {
    return {a.s + b.s, a.t + b.t};
  }
  friend ParameterPoint operator-(const ParameterPoint& a, const ParameterPoint& b) {
    return {a.s - b.s, a.t - b.t};
  }
  friend ParameterPoint operator*(const R& c, const ParameterPoint& a) { return {c * a.s, c * a.t}; }
  friend bool operator==(const ParameterPoint& a, const ParameterPoint& b) = default;
};

/// The signed area of the parallelogram spanned by a and b.
template <Field R>
R cross(const ParameterPoint<R>& a, const ParameterPoint<R>& b) {
  return a.s * b.t - a.t * b.s;
}

}  // namespace radcert
