// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/visible_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/conical_rule.h"

namespace radcert {

namespace {

using Point = Vector<double>;

/// A convex polygon whose corners are kept as differences from the point of view.
using Piece = std::vector<Point>;

class Cutter {
public:
  /// Both parts of a piece; an empty one has no corners.
  void cut(const Piece& piece, const Point& normal, double offset, Piece& inside, Piece& outside) {
    inside.clear();
    outside.clear();
    const std::size_t n = piece.size();
    heights_.resize(n);
    bool above = false;
    bool below = false;
    for (std::size_t k = 0; k < n; ++k) {
      heights_[k] = dot(normal, piece[k]) - offset;
      above = above || heights_[k] > 0;
      below = below || heights_[k] < 0;
    }
    if (!below) {
      inside = piece;
      return;
    }
    if (!above) {
      outside = piece;
      return;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = k + 1 == n ? 0 : k + 1;
      const double here = heights_[k];
      const double there = heights_[next];
      if (here >= 0) inside.push_back(piece[k]);
      if (here <= 0) outside.push_back(piece[k]);
      if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
        const Point at = piece[k] + (here / (here - there)) * (piece[next] - piece[k]);
        inside.push_back(at);
        outside.push_back(at);
      }
    }
  }

private:
  std::vector<double> heights_;
};

/// What a point sees of a polygon, with room that is used again from point to point.
class Viewer {
public:
  Viewer(const FacetCorners& source, const std::vector<const ConvexOccluder*>& occluders)
      : source_(source), occluders_(occluders) {
    for (const ConvexOccluder* occluder : occluders) normals_.push_back(vector_area(occluder->corners));
  }

  double flux(const Point& at, const Point& unit_normal) {
    count_ = 0;
    Piece& whole = next_place();
    for (const Point& q : source_) whole.push_back(q - at);
    for (std::size_t k = 0; k < occluders_.size() && count_ > 0; ++k)
      subtract(*occluders_[k], normals_[k], at);
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += lambert(pieces_[i], unit_normal);
    return sum;
  }

private:
  Piece& next_place() {
    if (count_ == pieces_.size()) pieces_.emplace_back();
    pieces_[count_].clear();
    return pieces_[count_++];
  }

  void subtract(const ConvexOccluder& occluder, const Point& normal, const Point& at) {
    const Point base = occluder.corners[0] - at;
    const double height = -dot(normal, base);
    if (height == 0) return;
    const double side = height > 0 ? 1 : -1;
    const std::size_t sides = occluder.corners.size();
    rays_.resize(sides);
    for (std::size_t k = 0; k < sides; ++k) rays_[k] = occluder.corners[k] - at;
    std::swap(pieces_, before_);
    const std::size_t count = count_;
    count_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      rest_ = before_[i];
      // Beyond the occluder's plane: the sign of normal.(Q - base) is not that of P.
      cut_off(-side * normal, -side * dot(normal, base));
      for (std::size_t k = 0; k < sides && !rest_.empty(); ++k)
        cut_off(-side * cross(rays_[k], rays_[k + 1 == sides ? 0 : k + 1]), 0);
    }
  }

  /// What of the rest lies outside is seen.
  void cut_off(const Point& normal, double offset) {
    if (rest_.empty()) return;
    cutter_.cut(rest_, normal, offset, inside_, outside_);
    if (outside_.size() >= 3) next_place() = outside_;
    std::swap(rest_, inside_);
    if (rest_.size() < 3) rest_.clear();
  }

  static double lambert(const Piece& piece, const Point& normal) {
    double sum = 0;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const Point& a = piece[k];
      const Point& b = piece[k + 1 == piece.size() ? 0 : k + 1];
      const Point across = cross(a, b);
      const double size = norm(across);
      if (size > 0) sum += std::atan2(size, dot(a, b)) * dot(normal, across) / size;
    }
    // Counterclockwise as seen from P: the cross products point out of the pyramid.
    return -sum / 2;
  }

  const FacetCorners& source_;
  const std::vector<const ConvexOccluder*>& occluders_;
  std::vector<Point> normals_;
  std::vector<Piece> pieces_;
  std::vector<Piece> before_;
  std::size_t count_ = 0;
  std::vector<Point> rays_;
  Piece rest_;
  Piece inside_;
  Piece outside_;
  Cutter cutter_;
};

/// A cell of the receiver.
struct Cell {
  std::array<Point, 3> corners;
  double value = 0;  ///< of one rule
  double error = 0;  ///< what its four parts differ from it by
  double finer = 0;  ///< their sum
  std::size_t number = 0;
  /// The largest error first, the older of equals.
  friend bool operator<(const Cell& a, const Cell& b) {
    return a.error != b.error ? a.error < b.error : a.number > b.number;
  }
};

class Receiver {
public:
  Receiver(const FacetCorners& polygon, Viewer& viewer, const TriangleRule<double>& rule)
      : viewer_(viewer), rule_(rule) {
    const Point area = vector_area(polygon);
    normal_ = (1 / norm(area)) * area;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const std::array<Point, 3> corners{polygon[0], polygon[k], polygon[k + 1]};
      push(corners, by_rule(corners));
    }
  }

  Estimate integral(const CubatureDemand& demand) {
    for (std::size_t n = cells_.size(); n < demand.most_cells; ++n) {
      if (error_ / 2 <= demand.tolerance) break;
      const Cell worst = cells_.top();
      cells_.pop();
      error_ -= worst.error;
      value_ -= worst.finer;
      const auto parts = quarters(worst.corners);
      for (const auto& part : parts) push(part, by_rule(part));
    }
    // Sums that were built up and taken down again carry their roundings: from the cells anew.
    Estimate out;
    for (; !cells_.empty(); cells_.pop()) out += {cells_.top().finer, cells_.top().error / 2};
    constexpr double rounding = 0x1p-50;
    // A shadow that falls between the points of both rules makes no difference: no radius below what was asked for.
    return {std::max(out.value, 0.0),
            std::max(2 * out.radius, 2 * demand.tolerance) + rounding * std::abs(out.value)};
  }

private:
  static std::array<std::array<Point, 3>, 4> quarters(const std::array<Point, 3>& c) {
    const Point ab = 0.5 * (c[0] + c[1]);
    const Point bc = 0.5 * (c[1] + c[2]);
    const Point ca = 0.5 * (c[2] + c[0]);
    return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {bc, ca, ab}}};
  }

  double by_rule(const std::array<Point, 3>& c) {
    const Point first = c[1] - c[0];
    const Point second = c[2] - c[0];
    double sum = 0;
    for (std::size_t i = 0; i < rule_.points.size(); ++i) {
      const auto& x = rule_.points[i].x;
      sum += rule_.weights[i] * viewer_.flux(c[0] + x[1] * first + x[2] * second, normal_);
    }
    return sum * norm(cross(first, second)) / std::numbers::pi;
  }

  void push(const std::array<Point, 3>& corners, double value) {
    Cell cell{.corners = corners, .value = value, .number = ++made_};
    for (const auto& part : quarters(corners)) cell.finer += by_rule(part);
    cell.error = std::abs(cell.finer - value);
    value_ += cell.finer;
    error_ += cell.error;
    cells_.push(cell);
  }

  Viewer& viewer_;
  const TriangleRule<double>& rule_;
  Point normal_;
  std::priority_queue<Cell> cells_;
  double value_ = 0;
  double error_ = 0;
  std::size_t made_ = 0;
};

}  // namespace

double visible_flux(const Vector<double>& point, const Vector<double>& unit_normal,
                    const FacetCorners& source, const std::vector<const ConvexOccluder*>& occluders) {
  return Viewer(source, occluders).flux(point, unit_normal);
}

Estimate visible_exchange_area(const FacetScene& scene, const FacetPair& pair, const CubatureDemand& demand) {
  expects(demand.tolerance > 0, "tolerance > 0", named("tolerance", demand.tolerance));
  if (pair.sight == PairSight::nothing || pair.sight == PairSight::hidden) return {};
  std::vector<const ConvexOccluder*> occluders;
  for (const std::size_t k : pair.occluders) occluders.push_back(&scene.occluders()[k]);
  const bool first_receives = norm(vector_area(pair.first)) <= norm(vector_area(pair.second));
  const FacetCorners& receiver = first_receives ? pair.first : pair.second;
  const FacetCorners& source = first_receives ? pair.second : pair.first;
  // Degree 3: beyond kinks a higher one gains nothing.
  static const TriangleRule<double> rule = conical_rule<double>(2, Gathering::nowhere);
  Viewer viewer(source, occluders);
  return Receiver(receiver, viewer, rule).integral(demand);
}

}  // namespace radcert
