// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <tuple>

#include "radcert/core/contract.h"
#include "radcert/geometry/polygon_triangulation.h"

namespace radcert {
namespace {

using Point = ParameterPoint<Rational>;
using Side = std::pair<std::size_t, std::size_t>;

/// Whether p lies on the segment from a to b.
bool lies_on(const Point& p, const Point& a, const Point& b) {
  if (cross(b - a, p - a).sign() != 0) return false;
  const Point along = b - a;
  const Rational at = along.s * (p.s - a.s) + along.t * (p.t - a.t);
  return at.sign() >= 0 && at <= along.s * along.s + along.t * along.t;
}

class Bisection {
public:
  explicit Bisection(PlaneTriangulation& triangulation) : t_(triangulation) {
    for (std::size_t k = 0; k < t_.triangles.size(); ++k) add_sides(k);
  }

  /// Bisects a triangle at its longest side; first, until that is the longest side of both, the neighbour
  /// there.
  void bisect(std::size_t triangle) {
    std::vector<std::size_t> chain{triangle};
    while (!chain.empty()) {
      const std::size_t here = chain.back();
      const std::size_t i = longest_side(here);
      const Side side = side_of(here, i);
      const auto across = of_side_.find({side.second, side.first});
      if (across != of_side_.end()) {
        const std::size_t there = across->second;
        const std::size_t j = longest_side(there);
        if (side_of(there, j) != across->first) {
          chain.push_back(there);
          continue;
        }
        const std::size_t middle = middle_of(side);
        halve(here, i, middle);
        halve(there, j, middle);
      } else {
        halve(here, i, middle_of(side));
      }
      chain.pop_back();
    }
  }

private:
  [[nodiscard]] Side side_of(std::size_t triangle, std::size_t i) const {
    return {t_.triangles[triangle][i], t_.triangles[triangle][(i + 1) % 3]};
  }

  /// Equal lengths are told apart by the numbers of the ends, the same way from both triangles.
  [[nodiscard]] std::size_t longest_side(std::size_t triangle) const {
    const auto rank = [&](std::size_t i) {
      const auto [a, b] = side_of(triangle, i);
      const Point d = t_.vertices[b] - t_.vertices[a];
      return std::tuple(d.s * d.s + d.t * d.t, std::min(a, b), std::max(a, b));
    };
    std::size_t longest = 0;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
      if (rank(longest) < rank(i)) longest = i;
    return longest;
  }

  std::size_t middle_of(const Side& side) {
    t_.vertices.push_back(Rational(1, 2) * (t_.vertices[side.first] + t_.vertices[side.second]));
    return t_.vertices.size() - 1;
  }

  void add_sides(std::size_t triangle) {
    for (std::size_t i = 0; i < 3; ++i) of_side_[side_of(triangle, i)] = triangle;
  }

  void halve(std::size_t triangle, std::size_t i, std::size_t middle) {
    const VertexTriple old = t_.triangles[triangle];
    of_side_.erase({old[i], old[(i + 1) % 3]});
    t_.triangles[triangle] = {old[i], middle, old[(i + 2) % 3]};
    t_.triangles.push_back({middle, old[(i + 1) % 3], old[(i + 2) % 3]});
    add_sides(triangle);
    add_sides(t_.triangles.size() - 1);
  }

  PlaneTriangulation& t_;
  std::map<Side, std::size_t> of_side_;
};

}  // namespace

PlaneTriangulation graded_toward(PlaneTriangulation triangulation, const PlanePolygon& polygon,
                                 std::span<const PolygonSide> sides, int times) {
  expects(times >= 0, "times >= 0", named("times", times));
  std::vector<std::pair<Point, Point>> segments;
  for (const PolygonSide& side : sides) {
    expects(side.loop < polygon.loops().size() && side.side < polygon.loops()[side.loop].size(),
            "a side of the polygon", named("loop", side.loop), named("side", side.side));
    const PolygonLoop& loop = polygon.loops()[side.loop];
    segments.emplace_back(loop[side.side], loop[(side.side + 1) % loop.size()]);
  }
  const auto on_a_side = [&](const Point& p) {
    return std::any_of(segments.begin(), segments.end(),
                       [&](const auto& segment) { return lies_on(p, segment.first, segment.second); });
  };
  Bisection bisection(triangulation);
  for (int round = 0; round < times; ++round) {
    std::vector<char> near(triangulation.vertices.size());
    for (std::size_t v = 0; v < near.size(); ++v) near[v] = on_a_side(triangulation.vertices[v]) ? 1 : 0;
    const std::vector<VertexTriple> before = triangulation.triangles;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const bool touches =
          std::any_of(before[k].begin(), before[k].end(), [&](std::size_t v) { return near[v] != 0; });
      // A triangle that a neighbour's bisection has halved already is done for this round.
      if (touches && triangulation.triangles[k] == before[k]) bisection.bisect(k);
    }
  }
  return triangulation;
}

}  // namespace radcert
