// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "radcert/surface/chart.h"

namespace radcert {

/// The signs of the two coordinates in a quadrant.
struct Quadrant {
  int x;
  int y;

  /// Whether (s,t) -> (x s, y t) keeps the sense of rotation.
  bool is_right_handed() const { return x * y > 0; }
  /// "pp", "mp", "mm" or "pm".
  std::string name() const { return {x > 0 ? 'p' : 'm', y > 0 ? 'p' : 'm'}; }
};

/// The four quadrants, counter-clockwise.
inline const std::vector<Quadrant>& quadrants() {
  static const std::vector<Quadrant> all{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  return all;
}

/// A point of the first quadrant of the unit disk.
template <Field T>
struct DiskPoint {
  T x;
  T y;
  T rest;  ///< 1 - x^2 - y^2
};

/// The first quadrant of the unit disk as an image of the unit triangle, the corner (0,0) at the centre.
/// Maths     (x,y) = (s,t)/sqrt(1-2st),  rest = (1-(s+t)) (1+(s+t))/(1-2st);  det D(x,y) = (1-2st)^-2, from 1
///           to 4. On s + t = 1, where 1 - 2st = s^2 + t^2, it is the arc (s,t)/|(s,t)| of `arc_point`
/// Source    ours; analytic on the closed triangle and nowhere degenerate, as polar coordinates are not
/// Requires  (s,t) in the unit triangle
/// Result    rounded as T rounds; rest is 0 on the rim exactly if s + t is 1
template <Field R, Field T>
DiskPoint<T> disk_point(const T& s, const T& t) {
  using std::sqrt;
  const T inverse = reciprocal(R(1) - R(2) * (s * t));
  const T root = sqrt(inverse);
  const T sum = s + t;
  return {s * root, t * root, (R(1) - sum) * (R(1) + sum) * inverse};
}

/// A point of the unit circle in the first quadrant.
template <Field T>
struct ArcPoint {
  T x;
  T y;
};

/// The arc of the unit circle in the first quadrant.
/// Maths     (1-s, s)/sqrt(1 - 2s(1-s)), from (1,0) to (0,1)
/// Source    ours; the rim of `disk_point`
/// Requires  0 <= s <= 1
/// Result    rounded as T rounds, with the bits of disk_point(1-s, s) where 1 - s is exact
template <Field R, Field T>
ArcPoint<T> arc_point(const T& s) {
  using std::sqrt;
  const T rest = R(1) - s;
  const T root = sqrt(reciprocal(R(1) - R(2) * (rest * s)));
  return {rest * root, s * root};
}

/// A quarter of a horizontal disk.
/// Maths     F(s,t) = (+-r x, +-r y, z),  (x,y) = disk_point(s,t)
/// Source    see disk_point
/// Requires  radius > 0
/// Result    see ChartOf; the third coordinate is one constant, so that G = 0 holds in every arithmetic
/// Limits    flat but not affine
template <Field R>
class DiskQuadrant {
public:
  DiskQuadrant(const Rational& radius, const Rational& height, const Quadrant& quadrant)
      : x_(from_rational<R>(quadrant.x * radius)),
        y_(from_rational<R>(quadrant.y * radius)),
        height_(from_rational<R>(height)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const DiskPoint<T> point = disk_point<R>(s, t);
    return {x_ * point.x, y_ * point.y, T(height_)};
  }

private:
  R x_;
  R y_;
  R height_;
};

/// Which way the inner normal points.
enum class Facing { up, down };

/// What is known of a quadrant of a piece of revolution.
/// Requires  D_s F x D_t F points upwards, or away from the body, where (s,t) -> (x s, y t) is right-handed
/// Result    the name piece/pp and so on, the orientation for inner normals that point so (down: into the
///           body), revolution about the z-axis with the rest of `structure`
ChartFacts quadrant_facts(const std::string& piece, const Quadrant& quadrant, ChartDomain domain,
                          Facing facing, ChartStructure structure = {});

/// A horizontal disk about the z-axis by four charts.
/// Maths     x^2 + y^2 <= r^2 at the height z
/// Source    see disk_point
/// Requires  radius > 0
/// Result    charts piece/pp, piece/mp, piece/mm, piece/pm over unit triangles; their plane is exact
std::vector<Chart> disk_charts(const std::string& piece, const Rational& radius, const Rational& height,
                               Facing facing);

}  // namespace radcert
