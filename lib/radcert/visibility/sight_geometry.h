// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"
#include "radcert/visibility/point_view.h"
#include "radcert/visibility/scene.h"
#include "radcert/visibility/whole_vector.h"

namespace radcert {

/// A rounded vector with what bounds its error.
/// Maths     |exact - value| <= k u size in each coordinate, u the unit roundoff of F; k depends on how the
///           vector was made
/// Result    size >= |value|
/// Limits    k is counted where the vector is used
template <class F>
struct SizedVector {
  Vector<F> value;
  Vector<F> size;
};

/// The sizes of the coordinates of a vector.
template <class F>
[[nodiscard]] Vector<F> sizes(const Vector<F>& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// The product: k is the sum of the factors' and 3, two roundings of its own and a little.
template <class F>
[[nodiscard]] SizedVector<F> sized_cross(const SizedVector<F>& a, const SizedVector<F>& b) {
  const Vector<F>& p = a.size;
  const Vector<F>& q = b.size;
  return {cross(a.value, b.value), {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x}};
}

/// Of a product of vectors with k = 13, a corner, and k = 5, a normal: 18 roundings passed on, one of the
/// product and two of the sum, and a little for the roundings of the bound itself.
inline constexpr int roundings_of_dot = 24;

/// A bound of what a . b, rounded, is off by.
/// Maths     k u |a|.|b|, and 2^-600 for what underflows: 2^-1074 from a product, which factors of at most
///           2^101, four in number, and a dozen terms follow
template <class F>
[[nodiscard]] F dot_rounding(const SizedVector<F>& a, const SizedVector<F>& b, int k = roundings_of_dot) {
  constexpr double underflow = 0x1p-600;
  return static_cast<F>(k) * unit_roundoff<F>() * dot(a.size, b.size) + static_cast<F>(underflow);
}

/// The directions, planes and corners that a viewpoint makes of a scene.
/// Maths     with v' = v - P: a side (a,b) spans the plane through P of normal n = a' x b'; the horizon has
///           the viewpoint's normal. A plane with a sign has m = sign n. Two adjacent planes of a convex
///           cone, counterclockwise as seen from P, meet in the direction m_second x m_first
/// Requires  the scene outlives it
/// Result    signs are exact: doubles with a bound, then whole numbers. Planes that share a vertex v meet in
///           +-v', so that such corners cost an orientation only; a plane of vertex v has v on it whatever
///           rounding says
/// Limits    belongs to one thread: it remembers whole numbers
class SightGeometry {
public:
  /// A plane of the table, with the side that counts.
  struct Side {
    std::size_t plane = 0;
    int sign = 1;
  };
  /// A direction in which two sides meet.
  struct Corner {
    Side first;
    Side second;
    std::size_t vertex = none;  ///< that both share, if any
    int sign = 1;               ///< the corner is sign times the vertex' direction
    SizedVector<double> direction;
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  SightGeometry(const Scene& scene, const Viewpoint& from);

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const Viewpoint& viewpoint() const { return from_; }

  /// Forgets all planes.
  void clear() { planes_.clear(); }
  /// The plane of a side, and which way it is: sign +1 is the side of (from - P) x (to - P).
  [[nodiscard]] Side side(std::size_t from, std::size_t to);
  [[nodiscard]] Side horizon();
  [[nodiscard]] Side side_of(const SightPlane& plane);
  [[nodiscard]] SightPlane description(const Side& side) const;
  [[nodiscard]] bool same_plane(std::size_t i, std::size_t j) const {
    return planes_[i].from == planes_[j].from && planes_[i].to == planes_[j].to;
  }

  /// In which the sides meet, first before second.
  [[nodiscard]] Corner corner(const Side& first, const Side& second);
  /// A triangle's corner: its vertex, where its sides (u,v) and (v,w) meet.
  [[nodiscard]] Corner corner_at(std::size_t vertex, const Side& first, const Side& second) const;
  /// The same direction, where other sides meet.
  [[nodiscard]] static Corner moved(Corner corner, const Side& first, const Side& second) {
    corner.first = first;
    corner.second = second;
    return corner;
  }

  /// The sign of m . v', of m . corner, and of normal . v'.
  [[nodiscard]] int sign_at(const Side& side, std::size_t vertex);
  [[nodiscard]] int sign_at(const Side& side, const Corner& corner);

  /// v' rounded: k = 1.
  template <class F>
  [[nodiscard]] SizedVector<F> ray(std::size_t vertex) const {
    const Vector<F> value = in<F>(scene_->vertex(vertex)) - in<F>(from_.point);
    return {value, sizes(value)};
  }
  /// m rounded, k = 5.
  template <class F>
  [[nodiscard]] SizedVector<F> normal(const Side& side) const {
    const Plane& plane = planes_[side.plane];
    const F sign = static_cast<F>(side.sign);
    if (plane.from == none) {
      const Vector<F> value = sign * in<F>(from_.normal);
      return {value, sizes(value)};
    }
    SizedVector<F> product = sized_cross(ray<F>(plane.from), ray<F>(plane.to));
    product.value = sign * product.value;
    return product;
  }
  /// The corner's direction rounded, k = 13.
  template <class F>
  [[nodiscard]] SizedVector<F> direction(const Corner& corner) const {
    if (corner.vertex == none) return sized_cross(normal<F>(corner.second), normal<F>(corner.first));
    SizedVector<F> along = ray<F>(corner.vertex);
    along.value = static_cast<F>(corner.sign) * along.value;
    return along;
  }
  static constexpr int rounding_of_normal = 5;
  static constexpr int rounding_of_direction = 13;

  /// The same, exactly: all times powers of one number, the rays with one and the same.
  [[nodiscard]] WholeVector whole_ray(std::size_t vertex) const;
  [[nodiscard]] WholeVector whole_normal(const Side& side);
  [[nodiscard]] WholeVector whole_direction(const Corner& corner);

  /// The corner as a point of a triangle in whose cone it lies: with (s,t) the parameters, each within 2^-51.
  [[nodiscard]] ParameterPoint<double> parameters(const Corner& corner, const std::array<Side, 3>& sides,
                                                  const VertexTriple& vertices);
  /// The same, exactly.
  [[nodiscard]] ParameterPoint<Rational> exact_parameters(const Corner& corner,
                                                          const std::array<Side, 3>& sides);

private:
  struct Plane {
    std::size_t from = none;
    std::size_t to = none;
    SizedVector<double> normal;
    std::optional<WholeVector> exact;
  };

  template <class F>
  static Vector<F> in(const Vector<double>& v) {
    return {static_cast<F>(v.x), static_cast<F>(v.y), static_cast<F>(v.z)};
  }
  /// The corner as a sum of the vertices' rays, each times one of these over their sum, by their distances
  /// from the sides.
  [[nodiscard]] std::array<WholeNumber, 3> weights(const Corner& corner, const std::array<Side, 3>& sides);
  const WholeVector& exact_normal(std::size_t plane);
  [[nodiscard]] std::size_t add(std::size_t from, std::size_t to);

  const Scene* scene_;
  Viewpoint from_;
  int exponent_ = 0;         ///< all coordinates of scene and viewpoint are multiples of 2^exponent_
  int normal_exponent_ = 0;  ///< those of the viewpoint's normal
  std::vector<Plane> planes_;
};

}  // namespace radcert
