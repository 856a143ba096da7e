// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/receiver_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace radcert {

namespace {

using Point = Vector<double>;

/// normal.(X - at), with the size below which it says nothing.
struct Height {
  Point normal;
  Point at;
  double least = 0;
  double operator()(const Point& p) const {
    const double height = dot(normal, p - at);
    return std::abs(height) <= least ? 0 : height;
  }
};

/// Where a corner seems to pass over a side: a plane, and the part of it where both are in line with P.
struct EventLine {
  Height plane;
  /// normal.(P - at) >= 0 for each within that part.
  std::array<Height, 3> within;
  std::size_t within_count = 0;
};

/// Both parts of a convex polygon.
std::pair<FacetCorners, FacetCorners> parted(const FacetCorners& cell, const std::vector<double>& heights) {
  std::pair<FacetCorners, FacetCorners> parts;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const std::size_t next = (k + 1) % cell.size();
    if (heights[k] >= 0) parts.first.push_back(cell[k]);
    if (heights[k] <= 0) parts.second.push_back(cell[k]);
    if ((heights[k] > 0) == (heights[next] > 0) || heights[k] == 0 || heights[next] == 0) continue;
    const Point at = cell[k] + (heights[k] / (heights[k] - heights[next])) * (cell[next] - cell[k]);
    parts.first.push_back(at);
    parts.second.push_back(at);
  }
  return parts;
}

class Cells {
public:
  Cells(const FacetScene& scene, const FacetCorners& receiver, const FacetCorners& source,
        const std::vector<std::size_t>& occluders)
      : scene_(scene), receiver_(receiver), source_(source), listed_(occluders) {
    cells_.push_back(receiver);
    for (const Point& p : source)
      for (const Point& q : receiver) reach_ = std::max(reach_, norm(p - q));
  }

  std::vector<FacetCorners> made() {
    for (const std::size_t k : listed_) {
      cut_by_plane(k);
      const ConvexOccluder& occluder = scene_.occluders()[k];
      const std::size_t count = occluder.corners.size();
      for (std::size_t c = 0; c < count; ++c) {
        cut_by_side(k, occluder.corners[c], occluder.corners[(c + 1) % count], occluder.beyond_side[c]);
        cut_by_corner(k, occluder.corners[c], occluder.around_corner[c]);
      }
    }
    return std::move(cells_);
  }

private:
  [[nodiscard]] bool is_listed(std::size_t occluder) const {
    return std::binary_search(listed_.begin(), listed_.end(), occluder);
  }

  [[nodiscard]] Height height(const Point& normal, const Point& at) const {
    // Differences and products of lengths up to the reach err by some units in the last place.
    constexpr double roundings = 0x1p-46;
    return {normal, at, roundings * norm(normal) * reach_};
  }

  [[nodiscard]] Height face(std::size_t occluder) const {
    const FacetCorners& corners = scene_.occluders()[occluder].corners;
    return height(vector_area(corners), corners[0]);
  }

  void cut_by_plane(std::size_t occluder) {
    EventLine line;
    line.plane = face(occluder);
    double low = 0;
    double high = 0;
    for (const Point& q : source_) {
      low = std::min(low, line.plane(q));
      high = std::max(high, line.plane(q));
    }
    if (low < 0 && high > 0) cut(line);
  }

  void cut_by_side(std::size_t occluder, const Point& from, const Point& to,
                   const std::optional<std::size_t>& beyond) {
    if (beyond && *beyond < occluder && is_listed(*beyond)) return;
    const Height here = face(occluder);
    const std::optional<Height> there = beyond ? std::optional(face(*beyond)) : std::nullopt;
    for (const Point& corner : source_) {
      if (there && here(corner) * (*there)(corner) > 0) continue;
      const Point first = from - corner;
      const Point second = to - corner;
      const Point normal = cross(first, second);
      // P - corner = a first + b second with a, b >= 0 and a + b >= 1.
      cut({height(normal, corner),
           {height(cross(second, normal), corner), height(cross(normal, first), corner),
            height(cross(to - from, normal), from)},
           3});
    }
  }

  void cut_by_corner(std::size_t occluder, const Point& corner, const std::vector<std::size_t>& around) {
    for (const std::size_t other : around)
      if (other < occluder && is_listed(other)) return;
    for (std::size_t k = 0; k < source_.size(); ++k) {
      const Point& from = source_[k];
      const Point& to = source_[(k + 1) % source_.size()];
      if (!around.empty()) {
        bool in_front = true;
        bool behind = true;
        for (const std::size_t other : around) {
          const Height f = face(other);
          in_front = in_front && f(from) > 0 && f(to) > 0;
          behind = behind && f(from) < 0 && f(to) < 0;
        }
        if (in_front || behind) continue;
      }
      const Point first = from - corner;
      const Point second = to - corner;
      const Point normal = cross(first, second);
      // corner - P = a first + b second with a, b >= 0.
      cut({height(normal, corner),
           {height(cross(normal, second), corner), height(cross(first, normal), corner), {}},
           2});
    }
  }

  void cut(const EventLine& line) {
    if (line.plane.normal == Point{} || misses(receiver_, line)) return;
    std::vector<FacetCorners> next;
    for (FacetCorners& cell : cells_) {
      if (next.size() + 2 > most_receiver_cells || misses(cell, line)) {
        next.push_back(std::move(cell));
        continue;
      }
      auto [above, below] = parted(cell, heights_);
      next.push_back(std::move(above));
      next.push_back(std::move(below));
    }
    cells_ = std::move(next);
  }

  /// Whether the line leaves a cell whole, or where it crosses it corner and side are not in line; heights_
  /// are those of its corners.
  [[nodiscard]] bool misses(const FacetCorners& cell, const EventLine& line) {
    bool above = false;
    bool below = false;
    heights_.resize(cell.size());
    for (std::size_t k = 0; k < cell.size(); ++k) {
      heights_[k] = line.plane(cell[k]);
      above = above || heights_[k] > 0;
      below = below || heights_[k] < 0;
    }
    if (!above || !below) return true;
    std::array<bool, 3> may{};
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const std::size_t next = (k + 1) % cell.size();
      if ((heights_[k] > 0) == (heights_[next] > 0) && heights_[k] != 0) continue;
      const double span = heights_[k] - heights_[next];
      const double part = span == 0 ? 0 : std::clamp(heights_[k] / span, 0.0, 1.0);
      const Point at = cell[k] + part * (cell[next] - cell[k]);
      for (std::size_t w = 0; w < line.within_count; ++w) may[w] = may[w] || line.within[w](at) >= 0;
    }
    for (std::size_t w = 0; w < line.within_count; ++w)
      if (!may[w]) return true;
    return false;
  }

  const FacetScene& scene_;
  const FacetCorners& receiver_;
  const FacetCorners& source_;
  const std::vector<std::size_t>& listed_;
  double reach_ = 0;
  std::vector<FacetCorners> cells_;
  std::vector<double> heights_;
};

}  // namespace

std::vector<FacetCorners> receiver_cells(const FacetScene& scene, const FacetCorners& receiver,
                                         const FacetCorners& source,
                                         const std::vector<std::size_t>& occluders) {
  return Cells(scene, receiver, source, occluders).made();
}

}  // namespace radcert
