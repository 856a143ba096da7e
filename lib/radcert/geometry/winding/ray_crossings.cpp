// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/winding/ray_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "radcert/geometry/orientation.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert {
namespace {

/// The point or the direction of a ray in both arithmetics.
struct Both {
  Vector<Rational> exact;
  Vector<BoundedDouble> bounded;

  explicit Both(Vector<Rational> v)
      : exact(std::move(v)),
        bounded{from_rational<BoundedDouble>(exact.x), from_rational<BoundedDouble>(exact.y),
                from_rational<BoundedDouble>(exact.z)} {}
};

struct Ray {
  Both from;
  Both way;
};

/// Whether a ray may meet a box: by a box that is a little too large.
bool may_meet(const BoundingBox& box, const Ray& ray) {
  double first = 0;
  double last = std::numeric_limits<double>::infinity();
  const auto cut = [&](double low, double high, const BoundedDouble& from, const BoundedDouble& way) {
    const double slack = 1e-9 * std::max({std::abs(low), std::abs(high), std::abs(from.value())});
    const double a = (low - slack - from.value()) / way.value();
    const double b = (high + slack - from.value()) / way.value();
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  const Vector<BoundedDouble>& from = ray.from.bounded;
  const Vector<BoundedDouble>& way = ray.way.bounded;
  cut(box.low.x, box.high.x, from.x, way.x);
  cut(box.low.y, box.high.y, from.y, way.y);
  cut(box.low.z, box.high.z, from.z, way.z);
  return first <= last * (1 + 1e-9) + 1e-300;
}

template <Field R>
R determinant(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c) {
  return dot(a, cross(b, c));
}

int sign(const BoundedDouble& x) { return x.smallest_size() > 0 ? (x.value() > 0 ? 1 : -1) : 0; }

/// A triangle as seen from where a ray begins.
class Sight {
public:
  Sight(const std::array<Vector<double>, 3>& corners, const Ray& ray) : corners_(corners), ray_(ray) {
    for (std::size_t k = 0; k < 3; ++k)
      to_[k] =
          Vector<BoundedDouble>{BoundedDouble::exactly(corners[k].x), BoundedDouble::exactly(corners[k].y),
                                BoundedDouble::exactly(corners[k].z)} -
          ray.from.bounded;
  }

  /// The sign of det(way, to corner k, to the next); all three are that of way . normal where the line of the
  /// ray passes through the triangle.
  [[nodiscard]] int side(std::size_t k) const {
    const std::size_t next = (k + 1) % 3;
    const int known = sign(determinant(ray_.way.bounded, to_[k], to_[next]));
    return known != 0 ? known : determinant(ray_.way.exact, exactly_to(k), exactly_to(next)).sign();
  }
  /// The sign of (corner 0 - from) . normal.
  [[nodiscard]] int height() const {
    const int known = sign(determinant(to_[0], to_[1], to_[2]));
    return known != 0 ? known : determinant(exactly_to(0), exactly_to(1), exactly_to(2)).sign();
  }

private:
  [[nodiscard]] Vector<Rational> exactly_to(std::size_t k) const {
    return exactly(corners_[k]) - ray_.from.exact;
  }

  const std::array<Vector<double>, 3>& corners_;
  const Ray& ray_;
  std::array<Vector<BoundedDouble>, 3> to_;
};

enum class Meeting { passes, passes_by, meets_a_side, begins_on_it };

/// How a ray meets a triangle, and the side of a crossing.
std::pair<Meeting, int> meeting(const std::array<Vector<double>, 3>& corners, const Ray& ray) {
  const Sight sight(corners, ray);
  const int first = sight.side(0);
  const int second = sight.side(1);
  if (first * second < 0) return {Meeting::passes_by, 0};
  const int third = sight.side(2);
  if (first * third < 0 || second * third < 0) return {Meeting::passes_by, 0};
  const int height = sight.height();
  // The line passes through the closed triangle, or lies in its plane.
  const int along = first != 0 ? first : second != 0 ? second : third;
  if (height == 0) return {along != 0 ? Meeting::begins_on_it : Meeting::meets_a_side, 0};
  if (along != 0 && height != along) return {Meeting::passes_by, 0};
  if (first == 0 || second == 0 || third == 0) return {Meeting::meets_a_side, 0};
  return {Meeting::passes, along};
}

/// The direction number k, along no axis.
Vector<Rational> direction(long k) {
  const Rational s(11 + 8 * k, 32);
  return {1, s, s * s};
}

std::vector<BoundingBox> boxes_of(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles) {
  std::vector<BoundingBox> boxes;
  boxes.reserve(triangles.size());
  for (const std::size_t t : triangles) boxes.push_back(box_about(mesh.corners(t)));
  return boxes;
}

std::vector<std::size_t> all_of(const TriangleMesh& mesh) {
  std::vector<std::size_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> without_degenerate(const TriangleMesh& mesh, std::vector<std::size_t> triangles) {
  std::erase_if(triangles, [&](std::size_t t) {
    const auto c = mesh.corners(t);
    return collinear(c[0], c[1], c[2]);
  });
  return triangles;
}

/// How a ray meets triangles: what it passes through, or the reason why that does not tell.
template <class Ignore>
Meeting collect(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles, const BoxTree& tree,
                const Ray& ray, const Ignore& ignored, std::vector<RayCrossing>& out) {
  out.clear();
  Meeting worst = Meeting::passes;
  tree.visit([&](const BoundingBox& box) { return may_meet(box, ray); },
             [&](std::size_t number) {
               const std::size_t t = triangles[number];
               const auto [how, side] = meeting(mesh.corners(t), ray);
               if (how == Meeting::passes_by) return true;
               if (how == Meeting::passes) {
                 out.push_back({t, side});
                 return true;
               }
               if (ignored(t)) return true;
               worst = how;
               return false;
             });
  return worst;
}

}  // namespace

Vector<Rational> point_inside(const std::array<Vector<double>, 3>& corners) {
  const Vector<Rational> a = exactly(corners[0]);
  return Rational(1, 4) * (a + a + exactly(corners[1]) + exactly(corners[2]));
}

RayCrossings::RayCrossings(const TriangleMesh& mesh) : RayCrossings(mesh, all_of(mesh)) {}

RayCrossings::RayCrossings(const TriangleMesh& mesh, std::vector<std::size_t> triangles)
    : mesh_(mesh),
      triangles_(without_degenerate(mesh, std::move(triangles))),
      tree_(boxes_of(mesh, triangles_)) {}

std::optional<std::vector<RayCrossing>> RayCrossings::from(const Vector<Rational>& point) const {
  std::vector<RayCrossing> out;
  const Both start(point);
  for (long k = 0;; ++k)
    switch (collect(
        mesh_, triangles_, tree_, {start, Both(direction(k))}, [](std::size_t) { return false; }, out)) {
      case Meeting::passes: return out;
      case Meeting::begins_on_it: return std::nullopt;
      default: break;
    }
}

std::optional<std::vector<RayCrossing>> RayCrossings::from_side(std::size_t triangle, int side) const {
  const auto own = mesh_.corners(triangle);
  if (collinear(own[0], own[1], own[2])) return std::nullopt;
  const Vector<Rational> a = exactly(own[0]);
  const Vector<Rational> normal = cross(exactly(own[1]) - a, exactly(own[2]) - a);
  const auto is_in_its_plane = [&](std::size_t t) {
    const auto c = mesh_.corners(t);
    return std::all_of(c.begin(), c.end(), [&](const Vector<double>& corner) {
      return orientation(own[0], own[1], own[2], corner) == 0;
    });
  };
  std::vector<RayCrossing> out;
  const Both start(point_inside(own));
  for (long k = 0;; ++k) {
    const Vector<Rational> way = direction(k);
    const int ahead = dot(way, normal).sign();
    if (ahead == 0) continue;
    switch (
        collect(mesh_, triangles_, tree_, {start, Both(ahead == side ? way : -way)}, is_in_its_plane, out)) {
      case Meeting::passes: return out;
      case Meeting::begins_on_it: return std::nullopt;
      default: break;
    }
  }
}

long winding_number(const std::vector<RayCrossing>& crossings) {
  return std::accumulate(crossings.begin(), crossings.end(), 0L,
                         [](long sum, const RayCrossing& crossing) { return sum + crossing.side; });
}

}  // namespace radcert
