// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// A parallelogram in space, the affine image of the unit square.
/// Maths     F(s,t) = origin + s first + t second
/// Source    the faces of [ac98, section 2.2]
/// Requires  first and second independent
/// Result    see ChartOf
template <Field R>
class Rectangle {
public:
  Rectangle(const Vector<Rational>& origin, const Vector<Rational>& first, const Vector<Rational>& second)
      : origin_(in_arithmetic(origin)), first_(in_arithmetic(first)), second_(in_arithmetic(second)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {origin_.x + first_.x * s + second_.x * t, origin_.y + first_.y * s + second_.y * t,
            origin_.z + first_.z * s + second_.z * t};
  }

private:
  static Vector<R> in_arithmetic(const Vector<Rational>& v) {
    return {from_rational<R>(v.x), from_rational<R>(v.y), from_rational<R>(v.z)};
  }
  Vector<R> origin_;
  Vector<R> first_;
  Vector<R> second_;
};

/// A rectangle as a chart; its plane is exact.
Chart make_rectangle(ChartFacts facts, const Vector<Rational>& origin, const Vector<Rational>& first,
                     const Vector<Rational>& second);
/// The same, its inner normal on the side of a given point.
/// Requires  `inside` off its plane, else ContractViolation
/// Result    the orientation of the facts is set, exactly
Chart make_rectangle(ChartFacts facts, const Vector<Rational>& origin, const Vector<Rational>& first,
                     const Vector<Rational>& second, const Vector<Rational>& inside);

/// The orientation of origin + s first + t second whose inner normal points to the side of a point.
/// Requires  the point off the plane, else ContractViolation
[[nodiscard]] Orientation orientation_towards(const Vector<Rational>& inside, const Vector<Rational>& origin,
                                              const Vector<Rational>& first, const Vector<Rational>& second);

}  // namespace radcert
