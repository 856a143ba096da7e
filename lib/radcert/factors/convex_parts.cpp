// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/convex_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"

namespace radcert {

namespace {

using Point = Vector<double>;
using Loop = std::vector<std::size_t>;  ///< numbers of vertices
using Side = std::pair<std::size_t, std::size_t>;

/// Projection of a plane along the axis on which its normal is longest, turned so that counterclockwise stays
/// so.
class Projection {
public:
  /// The rounded normal of a sliver may be anything: an axis serves if the exact projection has an area.
  explicit Projection(const std::array<Point, 3>& corners) {
    const Point n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const std::array<double, 3> size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
      return size[static_cast<std::size_t>(a)] > size[static_cast<std::size_t>(b)];
    });
    for (const int axis : axes) {
      axis_ = axis;
      const int turn = orientation(flat(corners[0]), flat(corners[1]), flat(corners[2]));
      turned_ = turn < 0;
      if (turn != 0) return;
    }
    expects(false, "a triangle with an area");
  }
  /// The sign of the turn at b, exactly; coordinates are only left out.
  [[nodiscard]] int turn(const Point& a, const Point& b, const Point& c) const {
    const int sign = orientation(flat(a), flat(b), flat(c));
    return turned_ ? -sign : sign;
  }

private:
  [[nodiscard]] ParameterPoint<double> flat(const Point& p) const {
    if (axis_ == 0) return {p.y, p.z};
    if (axis_ == 1) return {p.z, p.x};
    return {p.x, p.y};
  }
  int axis_ = 0;
  bool turned_ = false;
};

/// Polygons of one plane that are joined while they stay convex.
class ConvexUnion {
public:
  ConvexUnion(const std::vector<Point>& vertices, const Projection& projection)
      : vertices_(vertices), projection_(projection) {}

  /// The border of several triangles or loops as one loop, if there is one and it is convex.
  [[nodiscard]] std::optional<Loop> joined(const std::vector<Loop>& parts) const {
    std::set<Side> sides;
    for (const Loop& part : parts)
      for (std::size_t k = 0; k < part.size(); ++k) {
        const Side side{part[k], part[(k + 1) % part.size()]};
        if (sides.erase({side.second, side.first}) == 0 && !sides.insert(side).second) return std::nullopt;
      }
    if (sides.empty()) return std::nullopt;
    std::map<std::size_t, std::size_t> next;
    for (const Side& side : sides)
      if (!next.emplace(side.first, side.second).second) return std::nullopt;
    Loop loop;
    std::size_t at = next.begin()->first;
    do {
      loop.push_back(at);
      const auto found = next.find(at);
      if (found == next.end()) return std::nullopt;
      at = found->second;
    } while (at != loop.front() && loop.size() <= next.size());
    if (loop.size() != next.size()) return std::nullopt;
    return convex(loop) ? std::optional(loop) : std::nullopt;
  }

  /// The corners at which a convex loop turns.
  [[nodiscard]] FacetCorners corners(const Loop& loop) const {
    FacetCorners out;
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (turn(loop, k) > 0) out.push_back(vertices_[loop[k]]);
    return out;
  }

private:
  [[nodiscard]] int turn(const Loop& loop, std::size_t k) const {
    const std::size_t n = loop.size();
    return projection_.turn(vertices_[loop[(k + n - 1) % n]], vertices_[loop[k]],
                            vertices_[loop[(k + 1) % n]]);
  }
  /// A loop that never turns right and goes round once: seen from its first corner no other side turns right
  /// either.
  [[nodiscard]] bool convex(const Loop& loop) const {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (turn(loop, k) < 0) return false;
      const std::size_t next = (k + 1) % loop.size();
      if (projection_.turn(vertices_[loop[0]], vertices_[loop[k]], vertices_[loop[next]]) < 0) return false;
    }
    return true;
  }
  const std::vector<Point>& vertices_;
  const Projection& projection_;
};

/// All of the triangles if their union is convex, else pairs of neighbours as long as there are such.
std::vector<Loop> joined_parts(const ConvexUnion& plane, std::vector<Loop> parts) {
  if (const auto whole = plane.joined(parts)) return {*whole};
  for (bool changed = true; changed;) {
    changed = false;
    std::map<Side, std::size_t> owner;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = 0; k < parts[i].size(); ++k)
        owner[{parts[i][k], parts[i][(k + 1) % parts[i].size()]}] = i;
    std::vector<bool> taken(parts.size(), false);
    std::vector<Loop> next;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (taken[i]) continue;
      taken[i] = true;
      Loop mine = parts[i];
      for (std::size_t k = 0; k < parts[i].size(); ++k) {
        const auto other = owner.find({parts[i][(k + 1) % parts[i].size()], parts[i][k]});
        if (other == owner.end() || taken[other->second]) continue;
        if (const auto both = plane.joined({mine, parts[other->second]})) {
          mine = *both;
          taken[other->second] = true;
          changed = true;
          break;
        }
      }
      next.push_back(std::move(mine));
    }
    parts = std::move(next);
  }
  return parts;
}

}  // namespace

std::vector<ConvexPart> convex_parts(const Scene& scene, const std::vector<std::size_t>& triangles) {
  const Projection projection(scene.corners(triangles.front()));
  const ConvexUnion joiner(scene.mesh().vertices, projection);
  std::vector<Loop> loops;
  std::map<Side, std::size_t> owner;
  for (const std::size_t t : triangles) {
    const VertexTriple& v = scene.vertices(t);
    loops.push_back({v[0], v[1], v[2]});
    for (std::size_t k = 0; k < 3; ++k) owner[{v[k], v[(k + 1) % 3]}] = t;
  }
  std::vector<ConvexPart> out;
  for (Loop& loop : joined_parts(joiner, std::move(loops))) {
    const std::size_t triangle = owner.at({loop[0], loop[1]});
    out.push_back({.corners = joiner.corners(loop), .triangle = triangle});
  }
  return out;
}

}  // namespace radcert
