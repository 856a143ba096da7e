// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert::certificate {

/// A triangle between a side of a face and its centre, a rectangle of whose parameters an element is.
/// Maths     a + s (1-t) along + t inward; the area element is jacobian (1-t) ds dt. Components are those of
///           the exact vectors to the nearest double
struct SideTriangle {
  std::size_t face = 0;
  Vector<double> a;
  Vector<double> along;
  Vector<double> inward;
  double length = 0;    ///< of the side, from above
  double jacobian = 0;  ///< twice the area, from above
  double height = 0;    ///< of the centre over the side, from below
  /// The triangle of another plane with the same side, run through the other way.
  std::optional<std::size_t> beyond;

  [[nodiscard]] Vector<double> point(double s, double t) const {
    return a + (s * (1 - t)) * along + t * inward;
  }
};

/// A rectangle of the parameters of a side's triangle.
struct Box {
  double s0 = 0;
  double s1 = 1;
  double t0 = 0;
  double t1 = 1;
  [[nodiscard]] double middle_s() const { return 0.5 * (s0 + s1); }
  [[nodiscard]] double middle_t() const { return 0.5 * (t0 + t1); }
};

/// Of doubles computed from coordinates of at most 1 by a few dozen roundings: each adds at most 2^-51.
inline constexpr double slack = 0x1p-45;
/// How far a point computed by SideTriangle::point may be from the exact one, a coordinate.
/// Maths     u = 2^-53. s and t off by 3 u, s (1-t) by 8 u; times a component of at most 2: 20 u; t inward 10
///           u, a and two sums of at most 4: 9 u. Together less than 2^6 u
inline constexpr double displacement = 0x1p-47;
/// All of a bound's own roundings are within this.
inline constexpr double upward = 1 + 0x1p-38;

/// The surface in double, moved to the middle of its box and scaled by a power of 2, so that coordinates are
/// at most 1. T does not change by that.
/// Requires  surface_fault found nothing
class Scene {
public:
  explicit Scene(const PolyhedronCertificate& certificate);

  /// Lengths here are 2^-exponent() times those of the certificate.
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] std::size_t faces() const { return normals_.size(); }
  [[nodiscard]] const std::vector<SideTriangle>& triangles() const { return triangles_; }
  /// The place of a side of a face in triangles().
  [[nodiscard]] std::size_t triangle(std::size_t face, std::size_t side) const { return first_[face] + side; }
  [[nodiscard]] std::size_t triangles_of(std::size_t face) const { return first_[face + 1] - first_[face]; }
  /// Inner, of unit length, components rounded.
  [[nodiscard]] const Vector<double>& normal(std::size_t face) const { return normals_[face]; }
  [[nodiscard]] bool coplanar(std::size_t face, std::size_t other) const {
    return coplanar_[face * faces() + other] != 0;
  }
  /// Whether a side is parallel to the plane of a face, exactly.
  [[nodiscard]] bool parallel(std::size_t triangle, std::size_t face) const {
    return parallel_[triangle * faces() + face] != 0;
  }
  /// Whether two sides are parallel, exactly.
  [[nodiscard]] bool aligned(std::size_t triangle, std::size_t other) const {
    return aligned_[triangle * triangles_.size() + other] != 0;
  }

  /// Heights over the plane of a face: of a, and what along and inward add. Exactly 0 where they are.
  struct Heights {
    BoundedDouble of_a;
    BoundedDouble along;
    BoundedDouble inward;
    [[nodiscard]] BoundedDouble at(const BoundedDouble& s, const BoundedDouble& t) const {
      return of_a + s * (BoundedDouble(1) - t) * along + t * inward;
    }
  };
  [[nodiscard]] const Heights& heights(std::size_t triangle, std::size_t face) const {
    return heights_[triangle * faces() + face];
  }

private:
  int exponent_ = 0;
  std::vector<SideTriangle> triangles_;
  std::vector<std::size_t> first_;
  std::vector<Vector<double>> normals_;
  std::vector<char> coplanar_;
  std::vector<char> parallel_;
  std::vector<char> aligned_;
  std::vector<Heights> heights_;
};

/// The distance of a point from a segment, rounded.
[[nodiscard]] double segment_distance(const Vector<double>& p, const Vector<double>& from,
                                      const Vector<double>& to);

/// A plane quadrilateral, as distances from it are bounded.
/// Maths     the distance of a point from a convex polygon is at least that from its plane and, in the plane,
///           from the half plane of each of its sides
class Quadrilateral {
public:
  Quadrilateral(const SideTriangle& triangle, const Vector<double>& normal, const Box& box);
  /// At most the distance, rounding included.
  [[nodiscard]] double distance(const Vector<double>& p) const;

private:
  Vector<double> normal_;
  std::array<Vector<double>, 2> corners_;  ///< at s0, t0 and at s1, t1: each side has one of them
  std::vector<std::pair<std::size_t, Vector<double>>> outward_;  ///< of each side, with its corner
  double slack_ = 0;
};

}  // namespace radcert::certificate
