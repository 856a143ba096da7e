// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

using Corners = std::array<Vector<double>, 3>;

constexpr double unit = unit_roundoff<double>();

/// Refuses boxes that a segment certainly does not meet.
class SegmentProbe {
public:
  SegmentProbe(const Vector<double>& p, const Vector<double>& q)
      : p_(p),
        direction_(q - p),
        size_{std::abs(direction_.x), std::abs(direction_.y), std::abs(direction_.z)},
        about_(box_about(std::array<Vector<double>, 2>{p, q})) {}

  [[nodiscard]] bool operator()(const BoundingBox& box) const {
    if (box.high.x < about_.low.x || box.low.x > about_.high.x || box.high.y < about_.low.y ||
        box.low.y > about_.high.y || box.high.z < about_.low.z || box.low.z > about_.high.z)
      return false;
    // Separating axes: the direction times each coordinate axis. The middle, the halves, the difference from
    // p and the direction are rounded once or twice each, two products and a sum follow: ten roundings of
    // numbers no larger than `far` times the direction.
    const Vector<double> middle = 0.5 * box.low + 0.5 * box.high - p_;
    const Vector<double> half = 0.5 * box.high - 0.5 * box.low;
    const double far = 1 + 16 * unit;
    const Vector<double> slack = 16 * unit * (absolute(box.low) + absolute(box.high) + absolute(p_));
    const Vector<double> reach = far * half + slack;
    const auto parted = [](double m1, double m2, double d1, double d2, double s1, double s2, double r1,
                           double r2, double a1, double a2) {
      const double rounding = 16 * unit * (a1 * s2 + a2 * s1) + underflow;
      return std::abs(m1 * d2 - m2 * d1) > r1 * s2 + r2 * s1 + rounding;
    };
    const Vector<double> away = absolute(middle);
    return !parted(middle.x, middle.y, direction_.x, direction_.y, size_.x, size_.y, reach.x, reach.y, away.x,
                   away.y) &&
           !parted(middle.y, middle.z, direction_.y, direction_.z, size_.y, size_.z, reach.y, reach.z, away.y,
                   away.z) &&
           !parted(middle.z, middle.x, direction_.z, direction_.x, size_.z, size_.x, reach.z, reach.x, away.z,
                   away.x);
  }

private:
  // More than what underflow takes from the products.
  static constexpr double underflow = 0x1p-1000;
  static Vector<double> absolute(const Vector<double>& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  }
  Vector<double> p_;
  Vector<double> direction_;
  Vector<double> size_;
  BoundingBox about_;
};

/// The same number for points of a plane, without the coordinate in which the triangle's normal is largest.
ParameterPoint<Rational> shadow(const Vector<double>& v, int left_out) {
  const Vector<Rational> at = exactly(v);
  if (left_out == 0) return {at.y, at.z};
  return left_out == 1 ? ParameterPoint<Rational>{at.z, at.x} : ParameterPoint<Rational>{at.x, at.y};
}

/// Whether the open segment meets the closed triangle where all lie in one plane: t runs through an interval,
/// cut by each side.
bool meets_in_plane(const Corners& t, const Vector<double>& p, const Vector<double>& q) {
  const Vector<Rational> a = exactly(t[0]);
  const Vector<Rational> normal = cross(exactly(t[1]) - a, exactly(t[2]) - a);
  const int left_out = normal.x.sign() != 0 ? 0 : normal.y.sign() != 0 ? 1 : 2;
  const int turn = (left_out == 0 ? normal.x : left_out == 1 ? normal.y : normal.z).sign();
  const ParameterPoint<Rational> start = shadow(p, left_out);
  const ParameterPoint<Rational> along = shadow(q, left_out) - start;
  Rational first = 0;
  Rational last = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const ParameterPoint<Rational> from = shadow(t[k], left_out);
    const ParameterPoint<Rational> side = shadow(t[(k + 1) % 3], left_out) - from;
    // Inside where height + t slope >= 0.
    const Rational height = Rational(turn) * cross(side, start - from);
    const Rational slope = Rational(turn) * cross(side, along);
    if (slope.sign() == 0) {
      if (height.sign() < 0) return false;
    } else {
      const Rational at = -height / slope;
      if (slope.sign() > 0) {
        first = std::max(first, at);
      } else {
        last = std::min(last, at);
      }
    }
  }
  return first < last || (first == last && first.sign() > 0 && first < Rational(1));
}

bool meets(const Corners& t, const Vector<double>& p, const Vector<double>& q) {
  const int at_p = orientation(t[0], t[1], t[2], p);
  const int at_q = orientation(t[0], t[1], t[2], q);
  if (at_p == 0 && at_q == 0) return meets_in_plane(t, p, q);
  if (at_p * at_q >= 0) return false;
  const int ab = orientation(p, q, t[0], t[1]);
  const int bc = orientation(p, q, t[1], t[2]);
  if (ab * bc < 0) return false;
  const int ca = orientation(p, q, t[2], t[0]);
  return ab * ca >= 0 && bc * ca >= 0;
}

bool fits(const Vector<double>& v) {
  return std::abs(v.x) <= Scene::largest_coordinate && std::abs(v.y) <= Scene::largest_coordinate &&
         std::abs(v.z) <= Scene::largest_coordinate;
}

void check(const Scene& scene, const ScenePoint& p) {
  expects(fits(p.at), "coordinates of at most 2^100", named("x", p.at.x), named("y", p.at.y),
          named("z", p.at.z));
  if (p.triangle)
    expects(*p.triangle < scene.triangle_count(), "a triangle of the scene", named("triangle", *p.triangle),
            named("count", scene.triangle_count()));
}

bool behind(const Scene& scene, const ScenePoint& of, const Vector<double>& at) {
  if (!of.triangle) return false;
  const auto [a, b, c] = scene.corners(*of.triangle);
  return orientation(a, b, c, at) < 0;
}

}  // namespace

std::optional<std::size_t> blocker(const Scene& scene, const ScenePoint& p, const ScenePoint& q) {
  check(scene, p);
  check(scene, q);
  if (p.at == q.at) return std::nullopt;
  constexpr auto no_plane = static_cast<std::size_t>(-1);
  const std::size_t of_p = p.triangle ? scene.plane(*p.triangle) : no_plane;
  const std::size_t of_q = q.triangle ? scene.plane(*q.triangle) : no_plane;
  if (of_p != of_q || of_p == no_plane) {
    if (behind(scene, p, q.at)) return p.triangle;
    if (behind(scene, q, p.at)) return q.triangle;
  }
  std::optional<std::size_t> found;
  scene.tree().visit(SegmentProbe(p.at, q.at), [&](std::size_t triangle) {
    const std::size_t plane = scene.plane(triangle);
    if (plane == of_p || plane == of_q || !meets(scene.corners(triangle), p.at, q.at)) return true;
    found = triangle;
    return false;
  });
  return found;
}

bool visible(const Scene& scene, const ScenePoint& p, const ScenePoint& q) {
  return !blocker(scene, p, q).has_value();
}

}  // namespace radcert
