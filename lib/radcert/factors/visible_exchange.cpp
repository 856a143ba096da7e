// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/visible_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/factors/sight_events.h"
#include "radcert/polynomial/rules/conical_rule.h"

namespace radcert {

namespace {

using Point = Vector<double>;

double area_of(const ReceiverCell& c) { return norm(cross(c[1] - c[0], c[2] - c[0])) / 2; }

OrientedPolygon oriented(const FacetCorners& corners, const Point& unit_normal) {
  return {corners, unit_normal};
}

/// A triangle of the receiver.
struct PendingCell {
  ReceiverCell corners;
  CellSight sight;
  int order = 0;  ///< of the rule; 0: none
  double value = 0;
  double error = 0;
  std::size_t number = 0;
  /// The largest error first, the older of equals.
  friend bool operator<(const PendingCell& a, const PendingCell& b) {
    return a.error != b.error ? a.error < b.error : a.number > b.number;
  }
};

/// The triangles of a convex polygon on both sides of a line; the polygon's own where it does not pass
/// through.
void part(const ReceiverCell& cell, const EventLine& line, std::vector<ReceiverCell>& out) {
  std::array<double, 3> height{};
  bool above = false;
  bool below = false;
  // As SightEvents has it: lengths are at most about 1.
  constexpr double roundings = 0x1p-48;
  for (std::size_t k = 0; k < 3; ++k) {
    height[k] = dot(line.normal, cell[k] - line.at);
    if (std::abs(height[k]) <= roundings * norm(line.normal)) height[k] = 0;
    above = above || height[k] > 0;
    below = below || height[k] < 0;
  }
  if (!above || !below) {
    out.push_back(cell);
    return;
  }
  for (const double sign : {1.0, -1.0}) {
    std::vector<Point> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (sign * height[k] >= 0) polygon.push_back(cell[k]);
      if (height[k] * height[next] < 0)
        polygon.push_back(cell[k] + (height[k] / (height[k] - height[next])) * (cell[next] - cell[k]));
    }
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      out.push_back({polygon[0], polygon[k], polygon[k + 1]});
  }
}

class Receiver {
public:
  explicit Receiver(const ExchangeGeometry& geometry)
      : geometry_(geometry), viewer_(geometry), events_(geometry) {}

  Approximation integral(double tolerance, std::size_t most_cells) {
    std::vector<std::size_t> all(geometry_.screens.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (std::size_t k = 1; k + 1 < geometry_.receiver.size(); ++k)
      push({geometry_.receiver[0], geometry_.receiver[k], geometry_.receiver[k + 1]}, all, low_order);
    while (!cells_.empty() && made_ < most_cells && error_ > tolerance) {
      throw_if_interrupted();
      const PendingCell worst = cells_.top();
      cells_.pop();
      error_ -= worst.error;
      refine(worst);
      // A sum that is built up and taken down again carries its roundings.
      if (error_ < tolerance / 2 || cells_.empty()) sum_errors();
    }
    Approximation out = settled_;
    for (; !cells_.empty(); cells_.pop()) out += {cells_.top().value, cells_.top().error};
    return {std::max(out.value, 0.0), (used_rules_ ? std::max(out.radius, tolerance) : out.radius) +
                                          rounded_ + 0x1p-50 * std::abs(out.value)};
  }

private:
  static constexpr int low_order = 3;
  static constexpr int high_order = 5;

  void sum_errors() {
    error_ = 0;
    std::priority_queue<PendingCell> copy = cells_;
    for (; !copy.empty(); copy.pop()) error_ += copy.top().error;
  }

  static double error_on_kinks(const PendingCell& cell) {
    return rule_error_on_kinks(cell.order) * area_of(cell.corners) / std::numbers::pi * cell.sight.change;
  }

  void refine(const PendingCell& cell) {
    // Along the lines that matter most, as far as they make up most of the change; else in four.
    constexpr std::size_t most_lines = 4;
    if (cell.order == low_order && cell.error > 2 * error_on_kinks(cell)) {
      push(cell.corners, cell.sight.screens, high_order);
      return;
    }
    std::vector<EventLine> lines = cell.sight.lines;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const EventLine& a, const EventLine& b) { return a.change > b.change; });
    if (lines.size() > most_lines) lines.resize(most_lines);
    double of_lines = 0;
    for (const EventLine& line : lines) of_lines += line.change;
    std::vector<ReceiverCell> parts;
    if (2 * of_lines >= cell.sight.change && !lines.empty()) {
      parts.push_back(cell.corners);
      for (const EventLine& line : lines) {
        std::vector<ReceiverCell> next;
        for (const ReceiverCell& one : parts) part(one, line, next);
        parts = std::move(next);
      }
    }
    if (parts.size() < 2) {
      const ReceiverCell& c = cell.corners;
      const Point ab = 0.5 * (c[0] + c[1]);
      const Point bc = 0.5 * (c[1] + c[2]);
      const Point ca = 0.5 * (c[2] + c[0]);
      parts = {{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {bc, ca, ab}};
    }
    for (const ReceiverCell& one : parts) push(one, cell.sight.screens, low_order);
  }

  double by_rule(const ReceiverCell& c, const std::vector<std::size_t>& screens, int order) {
    static const auto rules = [] {
      std::array<TriangleRule<double>, high_order> all;
      for (int k = 1; k <= high_order; ++k)
        all[static_cast<std::size_t>(k - 1)] = conical_rule<double>(k, Grading::none);
      return all;
    }();
    const TriangleRule<double>& rule = rules[static_cast<std::size_t>(order - 1)];
    const Point first = c[1] - c[0];
    const Point second = c[2] - c[0];
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const auto& x = rule.points[i].x;
      sum += rule.weights[i] * viewer_.flux(c[0] + x[1] * first + x[2] * second, screens);
    }
    return sum * norm(cross(first, second)) / std::numbers::pi;
  }

  void push(const ReceiverCell& c, const std::vector<std::size_t>& screens, int order) {
    ++made_;
    const double area = area_of(c);
    if (area == 0) return;
    PendingCell cell{.corners = c, .sight = events_.of(c, screens), .order = order, .number = made_};
    if (cell.sight.hidden) return;
    if (cell.sight.screens.empty()) {
      settled_ += exchange_area({c.begin(), c.end()}, geometry_.source);
      return;
    }
    used_rules_ = true;
    // Each flux errs by roundings of 1, a cell's area by roundings of the product of its sides.
    rounded_ += 0x1p-46 * area + 0x1p-50 * norm(c[1] - c[0]) * norm(c[2] - c[0]);
    if (cell.sight.change >= cell.sight.unoccluded) {
      const Approximation whole = exchange_area({c.begin(), c.end()}, geometry_.source);
      cell.order = 0;
      cell.value = whole.value / 2;
      cell.error = whole.value / 2 + whole.radius;
    } else {
      constexpr double safety = 4;
      cell.value = by_rule(c, cell.sight.screens, order);
      cell.error =
          safety * std::abs(cell.value - by_rule(c, cell.sight.screens, order - 1)) + error_on_kinks(cell);
    }
    error_ += cell.error;
    cells_.push(std::move(cell));
  }

  const ExchangeGeometry& geometry_;
  SourceViewer viewer_;
  SightEvents events_;
  std::priority_queue<PendingCell> cells_;
  Approximation settled_ = Approximation::exact(0);
  double rounded_ = 0;
  double error_ = 0;
  std::size_t made_ = 0;
  bool used_rules_ = false;
};

}  // namespace

double visible_flux(const FacetScene& scene, const Vector<double>& point, const Vector<double>& unit_normal,
                    const FacetCorners& source, const std::vector<std::size_t>& occluders) {
  const Point area = vector_area(source);
  ExchangeGeometry geometry = exchange_geometry(scene, oriented({point}, unit_normal),
                                                oriented(source, (1 / norm(area)) * area), occluders);
  std::vector<std::size_t> all(geometry.screens.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return SourceViewer(geometry).flux((1 / geometry.unit) * (point - geometry.origin), all);
}

Approximation visible_exchange_area(const FacetScene& scene, const FacetPair& pair,
                                    const CubatureDemand& demand) {
  expects(demand.tolerance > 0, "tolerance > 0", named("tolerance", demand.tolerance));
  if (pair.sight == PairSight::nothing || pair.sight == PairSight::hidden) return Approximation::exact(0);
  const OrientedPolygon first = oriented(pair.first, pair.first_normal);
  const OrientedPolygon second = oriented(pair.second, pair.second_normal);
  const bool first_receives = norm(vector_area(pair.first)) <= norm(vector_area(pair.second));
  const ExchangeGeometry geometry = exchange_geometry(scene, first_receives ? first : second,
                                                      first_receives ? second : first, pair.occluders);
  const double unit_area = geometry.unit * geometry.unit;
  const Approximation found = Receiver(geometry).integral(demand.tolerance / unit_area, demand.most_cells);
  return {unit_area * found.value, unit_area * found.radius};
}

}  // namespace radcert
