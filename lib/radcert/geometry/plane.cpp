// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/plane.h"

#include "radcert/core/contract.h"

namespace radcert {

bool is_zero(const Vector<Rational>& v) { return v == Vector<Rational>{}; }

Plane::Plane(const Vector<Rational>& origin, const Vector<Rational>& first, const Vector<Rational>& second)
    : normal_(cross(first, second)), offset_(dot(normal_, origin)) {
  expects(!is_zero(normal_), "two independent directions span a plane");
}

bool same_plane(const Plane& a, const Plane& b) {
  const bool parallel = is_zero(cross(a.normal_, b.normal_));
  return parallel && dot(a.normal_, a.normal_) * b.offset_ == dot(a.normal_, b.normal_) * a.offset_;
}

}  // namespace radcert
