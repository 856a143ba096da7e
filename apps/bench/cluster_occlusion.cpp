// SPDX-License-Identifier: GPL-3.0-or-later
// How many pairs of clusters see each other in part, level by level, in rooms with boxes in them:
//   cluster_occlusion plate|room LEVELS
// A pair of triangles exchanges nothing where one lies behind the other's plane. It is visible where the hull
// of both has no point inside a box, and hidden where each segment between their corners passes through one
// and the same box: what a convex body hides from a point is convex, and so are the points from which it
// hides a set. Else it is partial, and is divided into the pairs of its children. A matrix that is exact
// about shadows has entries for the partial pairs of its elements, and for those that are near.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/geometry/vector.h"

namespace radcert::bench {
namespace {

using Point = Vector<double>;
using Triangle = std::array<Point, 3>;

struct Box {
  Point least;
  Point largest;
};

/// The room itself, which hides nothing, and what stands in it.
struct Room {
  Box walls;
  std::vector<Box> boxes;
};

Room plate() { return {{{0, 0, 0}, {4, 4, 4}}, {{{1, 1, 2}, {3, 3, 2.0625}}}}; }

/// A table, a cupboard, a bed, and a lamp that hangs above the table.
Room furnished_room() {
  Room room{{{0, 0, 0}, {4, 5, 2.5}}, {}};
  room.boxes.push_back({{1, 1, 0.7}, {2.5, 2, 0.75}});
  for (const double x : {1.05, 2.4})
    for (const double y : {1.05, 1.9}) room.boxes.push_back({{x, y, 0}, {x + 0.05, y + 0.05, 0.7}});
  room.boxes.push_back({{3.4, 2, 0}, {4, 3.5, 2}});
  room.boxes.push_back({{0, 3, 0.2}, {2, 4, 0.5}});
  room.boxes.push_back({{1.5, 1.3, 1.6}, {1.9, 1.7, 1.8}});
  return room;
}

double coordinate(const Point& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The two triangles of each face, seen counterclockwise from outside the box, or from inside.
void add_faces(const Box& box, bool inwards, std::vector<Triangle>& triangles) {
  const auto corner = [&](int which) {
    return Point{(which & 1) != 0 ? box.largest.x : box.least.x,
                 (which & 2) != 0 ? box.largest.y : box.least.y,
                 (which & 4) != 0 ? box.largest.z : box.least.z};
  };
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    triangles.push_back({corner(a), corner(b), corner(c)});
    triangles.push_back({corner(a), corner(c), corner(d)});
  }
  if (inwards)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
}

std::vector<Triangle> triangles_of(const Room& room) {
  std::vector<Triangle> triangles;
  add_faces(room.walls, true, triangles);
  for (const Box& box : room.boxes) add_faces(box, false, triangles);
  return triangles;
}

std::array<Triangle, 4> children(const Triangle& t) {
  const Point m01 = 0.5 * (t[0] + t[1]);
  const Point m12 = 0.5 * (t[1] + t[2]);
  const Point m20 = 0.5 * (t[2] + t[0]);
  return {Triangle{t[0], m01, m20}, {m01, t[1], m12}, {m20, m12, t[2]}, {m12, m20, m01}};
}

// Coordinates are sums of a few powers of two of the rooms' sizes: what touches is off by rounding alone.
constexpr double touching = 1e-12;

bool behind(const Triangle& a, const Triangle& b) {
  const Point normal = cross(b[1] - b[0], b[2] - b[0]);
  return std::all_of(a.begin(), a.end(), [&](const Point& p) { return dot(normal, p - b[0]) <= touching; });
}

/// Whether a plane with this normal has the points on one side and the box on the other.
bool separates(const Point& normal, const std::array<Point, 6>& points, const Box& box) {
  double least = dot(normal, points[0]);
  double largest = least;
  for (const Point& p : points) {
    least = std::min(least, dot(normal, p));
    largest = std::max(largest, dot(normal, p));
  }
  double box_least = 0;
  double box_largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double n = coordinate(normal, axis);
    const double a = n * coordinate(box.least, axis);
    const double b = n * coordinate(box.largest, axis);
    box_least += std::min(a, b);
    box_largest += std::max(a, b);
  }
  const double allowed = touching * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
  return largest <= box_least + allowed || box_largest <= least + allowed;
}

/// Two convex polytopes are apart exactly where a face of one or an edge of each gives a plane between them.
bool apart(const std::array<Point, 6>& points, const Box& box) {
  constexpr std::array<Point, 3> axes{Point{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Point& axis : axes)
    if (separates(axis, points, box)) return true;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Point edge = points[j] - points[i];
      for (const Point& axis : axes) {
        const Point normal = cross(edge, axis);
        if (dot(normal, normal) > 0 && separates(normal, points, box)) return true;
      }
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Point normal = cross(edge, points[k] - points[i]);
        if (dot(normal, normal) > 0 && separates(normal, points, box)) return true;
      }
    }
  return false;
}

/// Whether a segment has a point inside a box.
bool passes_through(const Point& p, const Point& q, const Box& box) {
  double from = 0;
  double to = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double start = coordinate(p, axis);
    const double along = coordinate(q, axis) - start;
    double enter = coordinate(box.least, axis) + touching - start;
    double leave = coordinate(box.largest, axis) - touching - start;
    if (along == 0) {
      if (enter >= 0 || leave <= 0) return false;
      continue;
    }
    enter /= along;
    leave /= along;
    from = std::max(from, std::min(enter, leave));
    to = std::min(to, std::max(enter, leave));
  }
  return from < to;
}

enum class Sight { nothing, visible, hidden, partial };

Sight sight(const Triangle& a, const Triangle& b, const std::vector<Box>& boxes) {
  if (behind(a, b) || behind(b, a)) return Sight::nothing;
  const std::array<Point, 6> points{a[0], a[1], a[2], b[0], b[1], b[2]};
  bool visible = true;
  for (const Box& box : boxes) {
    if (apart(points, box)) continue;
    visible = false;
    const bool hides = std::all_of(a.begin(), a.end(), [&](const Point& p) {
      return std::all_of(b.begin(), b.end(), [&](const Point& q) { return passes_through(p, q, box); });
    });
    if (hides) return Sight::hidden;
  }
  return visible ? Sight::visible : Sight::partial;
}

struct Counts {
  std::size_t visible = 0;
  std::size_t hidden = 0;
  std::size_t partial = 0;
};

/// The pairs of one level below a pair that is partial at the level before.
void count_below(const Triangle& a, const Triangle& b, const Room& room, std::size_t level,
                 std::vector<Counts>& counts) {
  const Sight found = sight(a, b, room.boxes);
  if (found == Sight::visible) ++counts[level].visible;
  if (found == Sight::hidden) ++counts[level].hidden;
  if (found != Sight::partial) return;
  ++counts[level].partial;
  if (level + 1 == counts.size()) return;
  for (const Triangle& p : children(a))
    for (const Triangle& q : children(b)) count_below(p, q, room, level + 1, counts);
}

void print_table(const Room& room, std::size_t levels) {
  const std::vector<Triangle> triangles = triangles_of(room);
  const std::vector<Counts> counts = parallel_reduce_ordered(
      triangles.size(), 1, std::vector<Counts>(levels),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Counts> part(levels);
        for (std::size_t i = begin; i < end; ++i)
          for (std::size_t j = i + 1; j < triangles.size(); ++j)
            count_below(triangles[i], triangles[j], room, 0, part);
        return part;
      },
      [](std::vector<Counts> a, const std::vector<Counts>& b) {
        for (std::size_t l = 0; l < a.size(); ++l) {
          a[l].visible += b[l].visible;
          a[l].hidden += b[l].hidden;
          a[l].partial += b[l].partial;
        }
        return a;
      });
  std::printf(
      "| level | clusters | partial pairs a cluster | newly visible | newly hidden "
      "|\n|---|---|---|---|---|\n");
  double clusters = static_cast<double>(triangles.size());
  for (std::size_t l = 0; l < levels; ++l, clusters *= 4)
    std::printf("| %zu | %.0f | %.1f | %.1f | %.1f |\n", l, clusters,
                2 * static_cast<double>(counts[l].partial) / clusters,
                2 * static_cast<double>(counts[l].visible) / clusters,
                2 * static_cast<double>(counts[l].hidden) / clusters);
}

int run(const std::vector<std::string>& words) {
  if (words.size() != 2 || (words[0] != "plate" && words[0] != "room")) {
    std::cerr << "cluster_occlusion plate|room LEVELS\n";
    return 2;
  }
  print_table(words[0] == "plate" ? plate() : furnished_room(), std::stoul(words[1]));
  return 0;
}

}  // namespace
}  // namespace radcert::bench

int main(int count, char** words) {
  try {
    return radcert::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
