// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// An affine function of space with rational coefficients.
/// Maths     l(X) = gradient . X + constant
/// Result    value(X) in any arithmetic; for R = Ball enclosed
struct AffineForm {
  Vector<Rational> gradient;
  Rational constant;

  template <Field R>
  R value(const Vector<R>& at) const {
    return from_rational<R>(gradient.x) * at.x + from_rational<R>(gradient.y) * at.y +
           from_rational<R>(gradient.z) * at.z + from_rational<R>(constant);
  }
};

/// A quadric with rational coefficients as the border of the set on its inner side.
/// Maths     q(X) = sum_i squares_i X_i^2 + linear(X) - nappe(X)^2, the last only where a nappe is given;
///           inner side: q(X) <= 0, and nappe(X) >= 0
/// Source    ellipsoids, elliptic paraboloids, cylinders and the nappes of cones, with axes along those of
///           space
/// Result    has_convex_inside(): decided exactly on the coefficients. Without a nappe q is convex if no
///           square is negative. With one the inner side is sqrt(p) <= nappe, p = q + nappe^2, and sqrt(p) is
///           convex, a norm of affine functions, if p has no linear terms and nothing negative. Sufficient,
///           not necessary
/// Limits    no products of two coordinates but those of the nappe
struct Quadric {
  Vector<Rational> squares;
  AffineForm linear;
  std::optional<AffineForm> nappe = std::nullopt;

  template <Field R>
  R value(const Vector<R>& at) const {
    const R sum = from_rational<R>(squares.x) * (at.x * at.x) + from_rational<R>(squares.y) * (at.y * at.y) +
                  from_rational<R>(squares.z) * (at.z * at.z) + linear.value(at);
    if (!nappe) return sum;
    const R height = nappe->value(at);
    return sum - height * height;
  }

  bool has_convex_inside() const {
    const bool squares_add = squares.x.sign() >= 0 && squares.y.sign() >= 0 && squares.z.sign() >= 0;
    if (!nappe) return squares_add;
    const Vector<Rational>& g = linear.gradient;
    return squares_add && linear.constant.sign() >= 0 && g.x.sign() == 0 && g.y.sign() == 0 &&
           g.z.sign() == 0;
  }
};

/// A line in space with rational coefficients.
struct Axis {
  Vector<Rational> point;
  Vector<Rational> direction;  ///< not zero
};

/// The exact facts about the shape of a chart's image, beside its plane where it is flat.
/// Maths     quadric: q(F(s,t)) = 0, and the inner normal is the direction of -grad q, so that the second
///           fundamental form of a quadric with a convex inside has one sign. ruling: F(s,t) = F(s,0) + t
///           ruling, so that the tangent planes are those along the profile F(s,0), and the surface is convex
///           if the profile is. revolution: the image is a part of a surface of revolution, every normal
///           meets its axis or is parallel to it, and the principal curvatures are those of the meridian and
///           of the circle
/// Source    what a proof that S lies in the boundary of a convex body starts from, next to the convexity of
///           the edges where pieces meet: [m06, Lemma 1] and [ac98, section 1] ask for it
/// Requires  what is stated holds by the chart's formula
/// Limits    absent: nothing is stated. A ruling alone leaves the sign of the profile's curvature to be shown
struct ChartStructure {
  std::optional<Quadric> quadric = std::nullopt;
  std::optional<Vector<Rational>> ruling = std::nullopt;
  std::optional<Axis> revolution = std::nullopt;
};

/// The z-axis.
inline Axis z_axis() { return {.point = {0, 0, 0}, .direction = {0, 0, 1}}; }

}  // namespace radcert
