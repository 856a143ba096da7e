// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"

namespace radcert::verification::psg10 {

/// The equation of a ray and a sphere.
/// Maths     p + s e is on the sphere where a s^2 + 2 b s + c = 0:  a = e.e, b = e.(p - C), c = |p - C|^2 -
///           r^2
/// Result    as R rounds
template <Field R>
struct RayOnSphere {
  R a;
  R b;
  R c;
  RayOnSphere(const Vector<R>& p, const Vector<R>& e, const Vector<R>& centre, const R& radius)
      : a(dot(e, e)), b(dot(e, p - centre)), c(dot(p - centre, p - centre) - radius * radius) {}

  [[nodiscard]] R discriminant() const { return b * b - a * c; }
};

}  // namespace radcert::verification::psg10
