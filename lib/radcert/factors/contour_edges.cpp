// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/contour_edges.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace radcert {

namespace {

using Point = Vector<Rational>;
using Place = std::array<Rational, 3>;

Point middle(const ExactCorners& polygon) {
  Point sum;
  for (const Point& p : polygon) sum = sum + p;
  return Rational(1, static_cast<long>(polygon.size())) * sum;
}

/// Positive inside of side k of a polygon, for points of its plane.
Rational inwards(const ExactCorners& polygon, const ExactPlane& plane, std::size_t k, const Point& p) {
  const Point& from = polygon[k];
  const Point& to = polygon[(k + 1) % polygon.size()];
  return dot(plane.normal, cross(to - from, p - from));
}

enum class Position { inside, border, outside };

Position position(const ExactCorners& polygon, const ExactPlane& plane, const Point& p) {
  bool border = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const int sign = inwards(polygon, plane, k, p).sign();
    if (sign < 0) return Position::outside;
    border = border || sign == 0;
  }
  return border ? Position::border : Position::inside;
}

std::vector<ExactCorners> split(const std::vector<ExactCorners>& cells, const ExactPlane& plane) {
  std::vector<ExactCorners> out;
  for (const ExactCorners& cell : cells) {
    std::vector<Rational> height;
    bool above = false;
    bool below = false;
    for (const Point& p : cell) {
      height.push_back(plane.height(p));
      above = above || height.back().sign() > 0;
      below = below || height.back().sign() < 0;
    }
    if (!above || !below) {
      out.push_back(cell);
      continue;
    }
    std::array<ExactCorners, 2> part;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const std::size_t next = (k + 1) % cell.size();
      if (height[k].sign() >= 0) part[0].push_back(cell[k]);
      if (height[k].sign() <= 0) part[1].push_back(cell[k]);
      if (height[k].sign() * height[next].sign() >= 0) continue;
      const Point at = cell[k] + (height[k] / (height[k] - height[next])) * (cell[next] - cell[k]);
      part[0].push_back(at);
      part[1].push_back(at);
    }
    out.push_back(std::move(part[0]));
    out.push_back(std::move(part[1]));
  }
  return out;
}

struct Face {
  const ExactCorners* corners;
  ExactPlane plane;
  Point middle;
};

class Edges {
public:
  Edges(const ExactCorners& receiver, const ExactCorners& source, const std::vector<ExactCorners>& screens)
      : receiver_(receiver), ground_(receiver), screen_count_(screens.size()) {
    for (const ExactCorners& screen : screens)
      faces_.push_back({&screen, ExactPlane(screen), middle(screen)});
    faces_.push_back({&source, ExactPlane(source), middle(source)});
  }

  std::optional<std::vector<ContourEdge>> all() {
    bool screen_on_ground = false;
    bool source_on_ground = false;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const ExactCorners& corners = *faces_[k].corners;
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const Point& from = corners[c];
        const Point& to = corners[(c + 1) % corners.size()];
        if (ground_.height(from).sign() == 0 && ground_.height(to).sign() == 0) {
          (k < screen_count_ ? screen_on_ground : source_on_ground) = true;
          continue;
        }
        add_pieces(from, to);
      }
    }
    if (screen_on_ground && source_on_ground) return std::nullopt;
    return std::move(edges_);
  }

private:
  void add_pieces(const Point& from, const Point& to) {
    std::vector<Rational> cuts{0, 1};
    std::vector<std::size_t> around;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const Face& face = faces_[k];
      if (face.plane.height(from).sign() != 0 || face.plane.height(to).sign() != 0) continue;
      around.push_back(k);
      for (std::size_t c = 0; c < face.corners->size(); ++c) {
        const Rational start = inwards(*face.corners, face.plane, c, from);
        const Rational end = inwards(*face.corners, face.plane, c, to);
        if (start.sign() * end.sign() < 0) cuts.push_back(start / (start - end));
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      add(from + cuts[k] * (to - from), from + cuts[k + 1] * (to - from), around);
  }

  void add(const Point& from, const Point& to, const std::vector<std::size_t>& around) {
    const Place a{from.x, from.y, from.z};
    const Place b{to.x, to.y, to.z};
    if (!known_.insert(std::minmax(a, b)).second) return;
    ContourEdge edge{.from = from, .to = to, .source_is_apart = true, .apart = {}, .parts = {}};
    const Point half = Rational(1, 2) * (from + to);
    std::vector<std::size_t> bordering;
    bool of_source = false;
    for (const std::size_t k : around) {
      const Position at = position(*faces_[k].corners, faces_[k].plane, half);
      if (k == screen_count_) {
        edge.source_is_apart = false;
        if (at == Position::outside) return;
        of_source = at == Position::border;
      } else {
        if (at == Position::inside) return;
        if (at == Position::border) bordering.push_back(k);
      }
    }
    for (std::size_t k = 0; k < screen_count_; ++k)
      if (std::find(around.begin(), around.end(), k) == around.end()) edge.apart.push_back(k);
    std::vector<ExactCorners> cells{receiver_};
    for (const std::size_t k : bordering) cells = split(cells, faces_[k].plane);
    for (ExactCorners& cell : cells) {
      const Point at = middle(cell);
      const auto side = [&](std::size_t k) {
        return dot(cross(from - at, to - from), faces_[k].middle - from).sign();
      };
      bool positive = true;
      bool negative = true;
      for (const std::size_t k : bordering) (side(k) > 0 ? positive : negative) = false;
      ContourEdge::Part part{.receiver = std::move(cell), .seen = 0, .whole = 0};
      if (of_source) {
        part.whole = side(screen_count_);
        (part.whole > 0 ? negative : positive) = false;
      }
      part.seen = static_cast<int>(positive) - static_cast<int>(negative);
      if (part.seen != 0 || part.whole != 0) edge.parts.push_back(std::move(part));
    }
    if (!edge.parts.empty()) edges_.push_back(std::move(edge));
  }

  const ExactCorners& receiver_;
  ExactPlane ground_;
  std::size_t screen_count_;
  std::vector<Face> faces_;  ///< the screens, then the source
  std::set<std::pair<Place, Place>> known_;
  std::vector<ContourEdge> edges_;
};

}  // namespace

ExactPlane::ExactPlane(const ExactCorners& polygon)
    : normal(cross(polygon[1] - polygon[0], polygon[2] - polygon[0])), constant(-dot(normal, polygon[0])) {}

std::optional<std::vector<ContourEdge>> contour_edges(const ExactCorners& receiver,
                                                      const ExactCorners& source,
                                                      const std::vector<ExactCorners>& screens) {
  return Edges(receiver, source, screens).all();
}

}  // namespace radcert
