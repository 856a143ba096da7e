// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/visible_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/factors/receiver_cells.h"
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
  Viewer(const FacetScene& scene, const FacetCorners& source, const std::vector<std::size_t>& occluders)
      : source_(source) {
    for (const std::size_t k : occluders) {
      const ConvexOccluder& occluder = scene.occluders()[k];
      occluders_.push_back({&occluder.corners, vector_area(occluder.corners), occluder.solid,
                            scene.solid_is_body(occluder.solid)});
    }
    std::stable_sort(occluders_.begin(), occluders_.end(),
                     [](const Screen& a, const Screen& b) { return a.solid < b.solid; });
  }

  double flux(const Point& at, const Point& unit_normal) {
    start(at);
    for (std::size_t k = 0; k < occluders_.size() && count_ > 0; ++k) subtract(occluders_[k], at);
    return remaining(unit_normal);
  }

  /// What is seen past each solid alone, and without any.
  struct Parts {
    double without = 0;
    double least = 0;  ///< past that solid which hides most
    double sum_of_shadows = 0;
    std::size_t shadows = 0;  ///< of more than rounding
  };
  Parts parts(const Point& at, const Point& unit_normal) {
    start(at);
    Parts out;
    out.without = remaining(unit_normal);
    out.least = out.without;
    for (std::size_t k = 0; k < occluders_.size();) {
      const std::size_t solid = occluders_[k].solid;
      start(at);
      for (; k < occluders_.size() && occluders_[k].solid == solid; ++k)
        if (count_ > 0) subtract(occluders_[k], at);
      const double seen = remaining(unit_normal);
      out.least = std::min(out.least, seen);
      out.sum_of_shadows += out.without - seen;
      out.shadows += seen < out.without - undecided ? 1 : 0;
    }
    return out;
  }

  /// What is seen, and what is hidden more than once, as often as it is so: 0 but for rounding where shadows
  /// of solids do not meet.
  struct Union {
    double seen;
    double overlap;
  };
  Union past_all(const Point& at, const Point& unit_normal) {
    const Parts alone = parts(at, unit_normal);
    const double seen = flux(at, unit_normal);
    return {seen, alone.sum_of_shadows - (alone.without - seen)};
  }

  /// A flux so much below another may equal it: roundings of some sides.
  static constexpr double undecided = 0x1p-46;

private:
  /// An occluder; of a body only the faces that look at P hide anything.
  struct Screen {
    const FacetCorners* corners;
    Point normal;
    std::size_t solid;
    bool front_only;
  };

  void start(const Point& at) {
    count_ = 0;
    Piece& whole = next_place();
    for (const Point& q : source_) whole.push_back(q - at);
  }

  double remaining(const Point& unit_normal) const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += lambert(pieces_[i], unit_normal);
    return sum;
  }

  Piece& next_place() {
    if (count_ == pieces_.size()) pieces_.emplace_back();
    pieces_[count_].clear();
    return pieces_[count_++];
  }

  void subtract(const Screen& occluder, const Point& at) {
    const FacetCorners& corners = *occluder.corners;
    const Point& normal = occluder.normal;
    const Point base = corners[0] - at;
    const double height = -dot(normal, base);
    if (height == 0 || (occluder.front_only && height < 0)) return;
    const double side = height > 0 ? 1 : -1;
    const std::size_t sides = corners.size();
    rays_.resize(sides);
    for (std::size_t k = 0; k < sides; ++k) rays_[k] = corners[k] - at;
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
  std::vector<Screen> occluders_;
  std::vector<Piece> pieces_;
  std::vector<Piece> before_;
  std::size_t count_ = 0;
  std::vector<Point> rays_;
  Piece rest_;
  Piece inside_;
  Piece outside_;
  Cutter cutter_;
};

/// A triangle of the receiver.
struct Cell {
  std::array<Point, 3> corners;
  bool one_shadow = true;  ///< what is seen is analytic
  int order = 0;           ///< of the rule
  double value = 0;
  double error = 0;
  std::size_t number = 0;
  /// The largest error first, the older of equals.
  friend bool operator<(const Cell& a, const Cell& b) {
    return a.error != b.error ? a.error < b.error : a.number > b.number;
  }
};

class Receiver {
public:
  Receiver(const FacetScene& scene, const FacetCorners& polygon, const FacetCorners& source,
           const std::vector<std::size_t>& occluders)
      : viewer_(scene, source, occluders) {
    const Point area = vector_area(polygon);
    normal_ = (1 / norm(area)) * area;
    for (const FacetCorners& cell : receiver_cells(scene, polygon, source, occluders)) add(cell, source);
  }

  Estimate integral(const CubatureDemand& demand) {
    for (std::size_t n = cells_.size(); !cells_.empty() && n < demand.most_cells; ++n) {
      if (error_ <= demand.tolerance) break;
      const Cell worst = cells_.top();
      cells_.pop();
      error_ -= worst.error;
      if (worst.one_shadow && worst.order == low_order)
        push(worst.corners, true, high_order);
      else
        for (const auto& part : quarters(worst.corners)) push(part, worst.one_shadow, low_order);
    }
    // A sum that was built up and taken down again carries its roundings: from the cells anew.
    Estimate out = settled_;
    const bool adaptive = !cells_.empty();
    for (; !cells_.empty(); cells_.pop()) out += {cells_.top().value, cells_.top().error};
    constexpr double rounding = 0x1p-50;
    // What lies between all points that were looked at shows in no difference: some times what was asked for.
    const double least_radius = adaptive ? 4 * demand.tolerance : 0;
    return {std::max(out.value, 0.0), std::max(out.radius, least_radius) + rounding * std::abs(out.value)};
  }

private:
  /// Nothing changes its kind on a cell: what is whole or hidden by one solid in the middle is so everywhere.
  void add(const FacetCorners& cell, const FacetCorners& source) {
    const double area = norm(vector_area(cell));
    const Viewer::Parts seen = viewer_.parts(roundness(cell).centre, normal_);
    if (seen.shadows == 0) {
      settled_ += exchange_area(cell, source);
      settled_.radius += Viewer::undecided * area;
    } else if (seen.least <= Viewer::undecided) {
      settled_.radius += Viewer::undecided * area;
    } else {
      for (std::size_t k = 1; k + 1 < cell.size(); ++k)
        push({cell[0], cell[k], cell[k + 1]}, seen.shadows == 1, low_order);
    }
  }

  static std::array<std::array<Point, 3>, 4> quarters(const std::array<Point, 3>& c) {
    const Point ab = 0.5 * (c[0] + c[1]);
    const Point bc = 0.5 * (c[1] + c[2]);
    const Point ca = 0.5 * (c[2] + c[0]);
    return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {bc, ca, ab}}};
  }

  double by_rule(const std::array<Point, 3>& c, int order) {
    static const auto rules = [] {
      std::array<TriangleRule<double>, high_order> all;
      for (int k = 1; k <= high_order; ++k)
        all[static_cast<std::size_t>(k - 1)] = conical_rule<double>(k, Gathering::nowhere);
      return all;
    }();
    const TriangleRule<double>& rule = rules[static_cast<std::size_t>(order - 1)];
    const Point first = c[1] - c[0];
    const Point second = c[2] - c[0];
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const auto& x = rule.points[i].x;
      sum += rule.weights[i] * viewer_.flux(c[0] + x[1] * first + x[2] * second, normal_);
    }
    return sum * norm(cross(first, second)) / std::numbers::pi;
  }

  void push(const std::array<Point, 3>& c, bool one_shadow, int order) {
    Cell cell{.corners = c, .one_shadow = one_shadow, .order = order, .number = ++made_};
    cell.value = by_rule(c, order);
    cell.error = std::abs(cell.value - by_rule(c, order - 1));
    // Two rules may agree by chance; a third one of lower order then does not.
    constexpr double gain = 8;
    if (order == high_order)
      cell.error = std::max(cell.error, std::abs(cell.value - by_rule(c, low_order)) / gain);
    if (!one_shadow) cell.error += meeting(c);
    error_ += cell.error;
    cells_.push(cell);
  }

  /// What the rules may miss of shadows that meet, or that hide everything together, in one part of a
  /// triangle alone: without a change of either kind what is seen is smooth. It grows with the square of the
  /// distance from where it begins: to g at a corner, if it begins at a third of the way from there to the
  /// other side, inside the rule's first points. Its integral is then g / 6 of a ninth of the area, about g /
  /// 64.
  double meeting(const std::array<Point, 3>& c) {
    const std::array<Point, 6> points{
        c[0], c[1], c[2], 0.5 * (c[0] + c[1]), 0.5 * (c[1] + c[2]), 0.5 * (c[2] + c[0])};
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Viewer::Union least{infinite, infinite};
    Viewer::Union most{0, 0};
    for (const Point& p : points) {
      const Viewer::Union here = viewer_.past_all(p, normal_);
      least = {std::min(least.seen, here.seen), std::min(least.overlap, here.overlap)};
      most = {std::max(most.seen, here.seen), std::max(most.overlap, here.overlap)};
    }
    double sum = 0;
    if (least.seen <= Viewer::undecided) sum += most.seen;
    if (least.overlap <= Viewer::undecided) sum += most.overlap;
    constexpr double unseen_part = 1.0 / 64;
    return unseen_part * sum * norm(cross(c[1] - c[0], c[2] - c[0])) / (2 * std::numbers::pi);
  }

  static constexpr int low_order = 3;
  static constexpr int high_order = 5;

  Viewer viewer_;
  Point normal_;
  std::priority_queue<Cell> cells_;
  Estimate settled_;
  double error_ = 0;
  std::size_t made_ = 0;
};

}  // namespace

double visible_flux(const FacetScene& scene, const Vector<double>& point, const Vector<double>& unit_normal,
                    const FacetCorners& source, const std::vector<std::size_t>& occluders) {
  return Viewer(scene, source, occluders).flux(point, unit_normal);
}

Estimate visible_exchange_area(const FacetScene& scene, const FacetPair& pair, const CubatureDemand& demand) {
  expects(demand.tolerance > 0, "tolerance > 0", named("tolerance", demand.tolerance));
  if (pair.sight == PairSight::nothing || pair.sight == PairSight::hidden) return {};
  const bool first_receives = norm(vector_area(pair.first)) <= norm(vector_area(pair.second));
  const FacetCorners& receiver = first_receives ? pair.first : pair.second;
  const FacetCorners& source = first_receives ? pair.second : pair.first;
  return Receiver(scene, receiver, source, pair.occluders).integral(demand);
}

}  // namespace radcert
