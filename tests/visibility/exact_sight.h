// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/visibility/scene.h"

namespace radcert::sample {

using Exact = Vector<Rational>;

inline Exact exact(const Vector<double>& v) {
  return {Rational::exactly(v.x), Rational::exactly(v.y), Rational::exactly(v.z)};
}

inline int sign_of_volume(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  return dot(cross(b - a, c - a), d - a).sign();
}

/// Visibility by rational numbers and one look at every triangle: the route that shares nothing with the
/// library's.
class ExactSight {
public:
  explicit ExactSight(const Scene& scene) {
    for (std::size_t k = 0; k < scene.triangle_count(); ++k) {
      const auto corners = scene.corners(k);
      triangles_.push_back({exact(corners[0]), exact(corners[1]), exact(corners[2])});
      const auto& [a, b, c] = triangles_.back();
      normals_.push_back(cross(b - a, c - a));
      offsets_.push_back(dot(normals_.back(), a));
    }
  }
  /// In front of a triangle's plane, on it, behind it: 1, 0, -1.
  [[nodiscard]] int height(std::size_t triangle, const Exact& p) const {
    return (dot(normals_[triangle], p) - offsets_[triangle]).sign();
  }
  [[nodiscard]] const std::array<Exact, 3>& corners(std::size_t triangle) const {
    return triangles_[triangle];
  }
  [[nodiscard]] Exact point(std::size_t triangle, const Rational& s, const Rational& t) const {
    const auto& [a, b, c] = triangles_[triangle];
    return a + s * (b - a) + t * (c - a);
  }
  [[nodiscard]] bool in_plane(std::size_t triangle, std::size_t of) const {
    return std::all_of(triangles_[triangle].begin(), triangles_[triangle].end(),
                       [&](const Exact& v) { return height(of, v) == 0; });
  }
  /// 1: the segment passes the triangle inside; 0: not at all; nothing where it touches its border or runs in
  /// its plane.
  [[nodiscard]] std::optional<int> passes(std::size_t triangle, const Exact& p, const Exact& q) const {
    const auto& [a, b, c] = triangles_[triangle];
    const int at_p = height(triangle, p);
    const int at_q = height(triangle, q);
    if (at_p == 0 && at_q == 0) return std::nullopt;
    if (at_p * at_q >= 0) return 0;
    const int ab = sign_of_volume(p, q, a, b);
    const int bc = sign_of_volume(p, q, b, c);
    const int ca = sign_of_volume(p, q, c, a);
    if (ab == bc && bc == ca) return 1;
    if (ab * bc < 0 || bc * ca < 0 || ca * ab < 0) return 0;
    return std::nullopt;
  }
  /// V(P,Q) for Q of a triangle, up to borders; the planes of both triangles hide nothing.
  [[nodiscard]] std::optional<bool> sees(const Exact& p, std::optional<std::size_t> own, const Exact& q,
                                         std::size_t of) const {
    bool touches = false;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      if (in_plane(k, of) || (own && in_plane(k, *own))) continue;
      const std::optional<int> crossing = passes(k, p, q);
      if (crossing == 1) return false;
      touches = touches || !crossing;
    }
    if (touches) return std::nullopt;
    return true;
  }

private:
  std::vector<std::array<Exact, 3>> triangles_;
  std::vector<Exact> normals_;
  std::vector<Rational> offsets_;
};

using ExactPolygon = std::vector<ParameterPoint<Rational>>;

/// 1 inside a convex polygon that runs counterclockwise, -1 outside, 0 on its border.
inline int place(const ExactPolygon& polygon, const ParameterPoint<Rational>& at) {
  int result = 1;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& from = polygon[k];
    const auto& to = polygon[(k + 1) % polygon.size()];
    result = std::min(result, cross(to - from, at - from).sign());
  }
  return result;
}

/// In the parameter plane, where the triangle has 1/2.
inline Rational area(const ExactPolygon& polygon) {
  Rational twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return twice / Rational(2);
}

}  // namespace radcert::sample
