// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace reference {

/// A function on a box of space, and an analytic one that agrees with it there.
/// Maths     on_box contains its values on the box; on_disks those of the analytic function on a product of
///           disks about the box
/// Source    see ComplexBall: a finite value means that the function is analytic
/// Requires  precision from BallPrecision::current()
/// Result    abs, min and max are the branch that holds on the whole box; where there is none, on_disks has
///           failed
struct BoxValue {
  Ball on_box;
  ComplexBall on_disks;

  explicit BoxValue(const Rational& constant) : on_box(constant), on_disks(constant) {}
  BoxValue(Ball box, ComplexBall disks) : on_box(std::move(box)), on_disks(std::move(disks)) {}

  BoxValue operator-() const { return {-on_box, -on_disks}; }
  friend BoxValue operator+(const BoxValue& a, const BoxValue& b) {
    return {a.on_box + b.on_box, a.on_disks + b.on_disks};
  }
  friend BoxValue operator-(const BoxValue& a, const BoxValue& b) {
    return {a.on_box - b.on_box, a.on_disks - b.on_disks};
  }
  friend BoxValue operator*(const BoxValue& a, const BoxValue& b) {
    return {a.on_box * b.on_box, a.on_disks * b.on_disks};
  }
  friend BoxValue operator/(const BoxValue& a, const BoxValue& b) {
    return {a.on_box / b.on_box, a.on_disks / b.on_disks};
  }
  friend BoxValue power(const BoxValue& x, long n) { return {power(x.on_box, n), power(x.on_disks, n)}; }
  friend BoxValue pow(const BoxValue& x, const BoxValue& y) {
    return {pow(x.on_box, y.on_box), pow(x.on_disks, y.on_disks)};
  }
  friend BoxValue sqrt(const BoxValue& x) { return {sqrt(x.on_box), sqrt(x.on_disks)}; }
  friend BoxValue exp(const BoxValue& x) { return {exp(x.on_box), exp(x.on_disks)}; }
  friend BoxValue log(const BoxValue& x) { return {log(x.on_box), log(x.on_disks)}; }
  friend BoxValue sin(const BoxValue& x) { return {sin(x.on_box), sin(x.on_disks)}; }
  friend BoxValue cos(const BoxValue& x) { return {cos(x.on_box), cos(x.on_disks)}; }
  friend BoxValue tan(const BoxValue& x) { return {tan(x.on_box), tan(x.on_disks)}; }
  friend BoxValue atan(const BoxValue& x) { return {atan(x.on_box), atan(x.on_disks)}; }
  friend BoxValue abs(const BoxValue& x) {
    if (certainly_at_most(Ball(0), x.on_box)) return x;
    if (certainly_at_most(x.on_box, Ball(0))) return -x;
    return {abs(x.on_box), ComplexBall::failed("abs where the sign changes")};
  }
  friend BoxValue min(const BoxValue& a, const BoxValue& b) {
    if (certainly_at_most(a.on_box, b.on_box)) return a;
    if (certainly_at_most(b.on_box, a.on_box)) return b;
    return {min(a.on_box, b.on_box), ComplexBall::failed("min where the order changes")};
  }
  friend BoxValue max(const BoxValue& a, const BoxValue& b) { return -min(-a, -b); }
};

}  // namespace reference

/// Numbers as they enter boxes: enclosed on both sides.
template <>
struct Constants<reference::BoxValue> {
  static reference::BoxValue from_rational(const Rational& q) { return reference::BoxValue(q); }
  static reference::BoxValue pi() { return {Ball::pi(), ComplexBall(Ball::pi())}; }
};

}  // namespace radcert
