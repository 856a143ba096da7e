// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/conforming.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace radcert {
namespace {

using Point = ParameterPoint<Rational>;

struct ByCoordinates {
  bool operator()(const Point& a, const Point& b) const { return std::tie(a.s, a.t) < std::tie(b.s, b.t); }
};

struct ByEnds {
  bool operator()(const std::pair<Point, Point>& a, const std::pair<Point, Point>& b) const {
    return std::tie(a.first.s, a.first.t, a.second.s, a.second.t) <
           std::tie(b.first.s, b.first.t, b.second.s, b.second.t);
  }
};

std::string text(const Point& p) { return "(" + p.s.to_text() + ", " + p.t.to_text() + ")"; }

/// Border sides by where they begin.
using Border = std::map<Point, Point, ByCoordinates>;

/// Walks from one vertex of a loop to the next along border sides, which are taken away; what is wrong
/// otherwise.
std::string walk(Border& border, const Point& from, const Point& to) {
  Point here = from;
  while (!(here == to)) {
    const auto next = border.find(here);
    if (next == border.end())
      return here == from ? "T1: the vertex " + text(from) + " of the polygon begins no side of the border"
                          : "T2: the border ends at " + text(here) + " within a side of the polygon";
    const Point there = next->second;
    const Point along = to - here;
    const Point step = there - here;
    // Straight on, and not beyond the end.
    const Rational ahead = along.s * step.s + along.t * step.t;
    if (cross(along, step).sign() != 0 || ahead.sign() <= 0 ||
        step.s * step.s + step.t * step.t > along.s * along.s + along.t * along.t)
      return "T2: the side from " + text(here) + " to " + text(there) +
             " has no triangle on its other side and is no part of the polygon's";
    border.erase(next);
    here = there;
  }
  return {};
}

}  // namespace

Outcome<void> conforming(std::span<const PolygonLoop> loops, std::span<const DomainTriangle> triangles) {
  std::map<std::pair<Point, Point>, std::size_t, ByEnds> sides;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const DomainTriangle& t = triangles[k];
    if (cross(t[1] - t[0], t[2] - t[0]).sign() <= 0)
      return because("triangle " + std::to_string(k) + " is clockwise or flat");
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [at, added] = sides.try_emplace({t[i], t[(i + 1) % 3]}, k);
      if (!added)
        return because("T3: triangles " + std::to_string(at->second) + " and " + std::to_string(k) +
                       " lie on the same side of the side from " + text(t[i]) + " to " +
                       text(t[(i + 1) % 3]));
    }
  }
  Border border;
  for (const auto& [ends, triangle] : sides) {
    if (sides.contains({ends.second, ends.first})) continue;
    if (!border.emplace(ends.first, ends.second).second)
      return because("T3: two sides of the border begin at " + text(ends.first));
  }
  for (const PolygonLoop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (const std::string wrong = walk(border, loop[i], loop[(i + 1) % loop.size()]); !wrong.empty())
        return because(wrong);
  if (!border.empty())
    return because("T3: the side from " + text(border.begin()->first) + " to " +
                   text(border.begin()->second) + " has no triangle on its other side");
  return {};
}

}  // namespace radcert
