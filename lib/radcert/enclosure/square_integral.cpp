// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/square_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/enclosure/ellipse_bound.h"
#include "radcert/enclosure/product_rule.h"

namespace radcert {

namespace {

/// The ellipses that are tried: from one in which a side is better bisected, to one in which few nodes are
/// left to win.
constexpr std::array rhos{1.7, 2.1, 2.7, 3.5, 4.5, 6.0, 8.0, 11.0, 16.0, 24.0, 36.0, 60.0, 100.0};
constexpr int first_rho = 3;

const WorkLimit evaluations_of_a_bound("enclosure/square_integral: evaluations for a bound on an ellipse",
                                       160, 1, "no bound: a smaller ellipse, or the cell is halved");
const WorkLimit evaluations_of_a_comparison("enclosure/square_integral: evaluations to compare two sides", 24,
                                            1, "another side is halved: no value depends on it");

struct OpenCell {
  std::size_t function = 0;
  SquareCell sides;
  std::array<int, 2> rho{first_rho, first_rho};  ///< where the search begins, for x and y
};

/// What one visit of a cell brought.
struct Visit {
  std::optional<Ball> value;     ///< the enclosure, where the cell is finished
  double error = 0;              ///< what it took of the allowance
  std::vector<OpenCell> halves;  ///< the cell's parts, where it is not
  long evaluations = 0;
  bool out_of_work = false;
  const char* obstacle = nullptr;
};

/// A rule, and the ellipse that its error is bounded by.
struct RuleChoice {
  RuleInOneVariable rule;
  int rho = 0;
};

class CellVisit {
public:
  CellVisit(const SquareFunction& f, const OpenCell& cell, double allowance, long work)
      : f_(f),
        cell_(cell),
        allowance_(allowance),
        work_(work),
        half_x_((Ball(cell.sides.x_high) - Ball(cell.sides.x_low)) / 2),
        half_y_((Ball(cell.sides.y_high) - Ball(cell.sides.y_low)) / 2) {}

  Visit visit() && {
    const std::optional<RuleChoice> x = best_rule(SquareAxis::x);
    if (visit_.out_of_work) return std::move(visit_);
    const std::optional<RuleChoice> y = best_rule(SquareAxis::y);
    if (visit_.out_of_work) return std::move(visit_);
    if (x && y) {
      if (!by_rule(x->rule, y->rule) && !visit_.out_of_work) bisect(longer_side());
    } else if (!by_range() && !visit_.out_of_work) {
      bisect(x ? SquareAxis::y : (y ? SquareAxis::x : rougher_side()));
    }
    return std::move(visit_);
  }

private:
  /// Counts evaluations before they are made; false where they are too many.
  bool take(long evaluations) {
    if (visit_.evaluations + evaluations > work_) {
      visit_.out_of_work = true;
      return false;
    }
    visit_.evaluations += evaluations;
    return true;
  }

  /// Enough nodes for a quarter of the allowance, by the logarithm of the bound; confirmed in balls.
  std::optional<RuleChoice> rule_for(double bound, int rho) const {
    const double r = rhos[static_cast<std::size_t>(rho)];
    const double share = allowance_ / 4;
    const double area = half_x_.to_double() * half_y_.to_double();
    const double needed =
        std::log2(bound) + std::log2(area) - std::log2(share) + 3 - std::log2(1 - 1 / (r * r));
    const int most = static_cast<int>(std::max<long>(16, BallPrecision::current()));
    // Of a function that is 0 on the ellipse the logarithm is infinite.
    const double count = std::ceil(needed / (2 * std::log2(r)));
    if (count > most) return std::nullopt;
    const int nodes = count > 2 ? static_cast<int>(count) : 2;
    return RuleChoice{.rule = rule_for_ellipse(nodes, r, bound), .rho = rho};
  }

  std::optional<RuleChoice> try_rho(SquareAxis axis, int rho) {
    const long budget = evaluations_of_a_bound.value();
    if (!take(budget)) return std::nullopt;
    const EllipseBound found =
        bound_on_ellipse(f_, cell_.sides, axis, rhos[static_cast<std::size_t>(rho)], budget);
    visit_.evaluations -= budget - found.evaluations;
    if (!std::isfinite(found.bound)) {
      visit_.obstacle = found.failure;
      return std::nullopt;
    }
    return rule_for(found.bound, rho);
  }

  /// From the parent's ellipse up while the nodes become fewer, or down to the first that has a bound.
  std::optional<RuleChoice> best_rule(SquareAxis axis) {
    int& start = cell_.rho[axis == SquareAxis::x ? 0 : 1];
    std::optional<RuleChoice> best = try_rho(axis, start);
    const bool upwards = best.has_value();
    const int last = static_cast<int>(rhos.size()) - 1;
    for (int rho = start; !visit_.out_of_work && (upwards ? rho < last : rho > 0);) {
      rho += upwards ? 1 : -1;
      std::optional<RuleChoice> other = try_rho(axis, rho);
      if (!upwards && !other) continue;
      if (!other || (best && other->rule.nodes >= best->rule.nodes)) break;
      best = std::move(other);
      if (!upwards) break;
    }
    start = best ? best->rho : 0;
    return best;
  }

  bool by_rule(const RuleInOneVariable& x, const RuleInOneVariable& y) {
    if (!take(static_cast<long>(x.nodes) * y.nodes)) return false;
    const auto [value, error] = by_product_rule(f_, cell_.sides, x, y);
    if (!value.is_finite()) {
      visit_.obstacle = value.failure().data();
      return false;
    }
    visit_.error = error.upper_double();
    if (visit_.error > allowance_) return false;
    visit_.value = value;
    return true;
  }

  Ball side_x() const { return hull(Ball(cell_.sides.x_low), Ball(cell_.sides.x_high)); }
  Ball side_y() const { return hull(Ball(cell_.sides.y_low), Ball(cell_.sides.y_high)); }

  bool by_range() {
    if (!take(1)) return false;
    const Ball value = 4 * half_x_ * half_y_ * f_.in_balls(side_x(), side_y());
    if (!value.is_finite() || value.radius() > allowance_) return false;
    visit_.value = value;
    visit_.error = value.radius();
    return true;
  }

  SquareAxis longer_side() const { return certainly_less(half_x_, half_y_) ? SquareAxis::y : SquareAxis::x; }

  /// The side along which the values of the complex formula vary more, the other variable in the middle.
  SquareAxis rougher_side() {
    constexpr double rho = 1.2;
    const long budget = evaluations_of_a_comparison.value();
    if (!take(2 * budget)) return SquareAxis::x;
    SquareCell along_x = cell_.sides;
    along_x.y_low = along_x.y_high = cell_.sides.y_low + (cell_.sides.y_high - cell_.sides.y_low) / 2;
    SquareCell along_y = cell_.sides;
    along_y.x_low = along_y.x_high = cell_.sides.x_low + (cell_.sides.x_high - cell_.sides.x_low) / 2;
    const EllipseBound x = bound_on_ellipse(f_, along_x, SquareAxis::x, rho, budget);
    const EllipseBound y = bound_on_ellipse(f_, along_y, SquareAxis::y, rho, budget);
    if (std::isfinite(x.bound) != std::isfinite(y.bound)) {
      return std::isfinite(x.bound) ? SquareAxis::y : SquareAxis::x;
    }
    if (!std::isfinite(x.bound) || x.bound == y.bound) return longer_side();
    return x.bound > y.bound ? SquareAxis::x : SquareAxis::y;
  }

  void bisect(SquareAxis axis) {
    double SquareCell::*low = axis == SquareAxis::x ? &SquareCell::x_low : &SquareCell::y_low;
    double SquareCell::*high = axis == SquareAxis::x ? &SquareCell::x_high : &SquareCell::y_high;
    const double middle = cell_.sides.*low + (cell_.sides.*high - cell_.sides.*low) / 2;
    if (!(cell_.sides.*low < middle && middle < cell_.sides.*high)) return;
    OpenCell first = cell_;
    for (int& rho : first.rho) rho = std::min(rho + 1, static_cast<int>(rhos.size()) - 1);
    OpenCell second = first;
    first.sides.*high = middle;
    second.sides.*low = middle;
    visit_.halves = {std::move(first), std::move(second)};
  }

  const SquareFunction& f_;
  OpenCell cell_;
  double allowance_;
  long work_;
  Ball half_x_;
  Ball half_y_;
  Visit visit_;
};

/// What can be said of a cell that was not finished.
Ball range_over(const SquareFunction& f, const SquareCell& cell) {
  const Ball x = hull(Ball(cell.x_low), Ball(cell.x_high));
  const Ball y = hull(Ball(cell.y_low), Ball(cell.y_high));
  return (Ball(cell.x_high) - Ball(cell.x_low)) * (Ball(cell.y_high) - Ball(cell.y_low)) * f.in_balls(x, y);
}

}  // namespace

Enclosure integral_over_squares(std::span<const SquareFunction> functions, const Demand& demand) {
  expects(demand.radius > 0 && demand.work_limit >= 1, "radius > 0, work_limit >= 1",
          named("radius", demand.radius), named("work_limit", demand.work_limit));
  const long bits = BallPrecision::current();
  // Half of the demand for the errors of rules and ranges, half for rounding. Of the errors' half, the cells
  // that are open share out one half of what is left, so that the whole is never spent.
  double left = demand.radius / 2;
  Ball total;
  long evaluations = 0;
  std::vector<OpenCell> open;
  for (std::size_t k = 0; k < functions.size(); ++k) open.push_back({.function = k, .sides = {}});

  std::string why;
  const char* obstacle = nullptr;
  while (!open.empty() && why.empty()) {
    const double allowance = left / (2 * static_cast<double>(open.size()));
    std::vector<OpenCell> next;
    // The work limit is shared out among the cells that are visited at once.
    constexpr std::size_t at_once = 32;
    for (std::size_t begin = 0; begin < open.size(); begin += at_once) {
      const std::size_t count = std::min(at_once, open.size() - begin);
      const long share = (demand.work_limit - evaluations) / static_cast<long>(count);
      std::vector<Visit> visits(count);
      if (why.empty()) {
        parallel_for(count, 1, [&](std::size_t from, std::size_t to) {
          const BallPrecision inside(bits);
          for (std::size_t i = from; i < to; ++i) {
            const OpenCell& cell = open[begin + i];
            visits[i] = CellVisit(functions[cell.function], cell, allowance, share).visit();
          }
        });
      }
      for (std::size_t i = 0; i < count; ++i) {
        Visit& visit = visits[i];
        evaluations += visit.evaluations;
        if (visit.obstacle != nullptr) obstacle = visit.obstacle;
        if (visit.value) {
          total += *visit.value;
          left -= visit.error;
        } else if (!visit.halves.empty()) {
          for (OpenCell& half : visit.halves) next.push_back(std::move(half));
        } else {
          if (why.empty()) {
            why = visit.out_of_work
                      ? "the work limit of " + std::to_string(demand.work_limit) + " evaluations"
                      : "a cell too small to be bisected";
          }
          next.push_back(open[begin + i]);
        }
      }
    }
    open = std::move(next);
  }
  if (!why.empty()) {
    why += " was reached with " + std::to_string(open.size()) + " cells open";
    if (obstacle != nullptr) why += std::string(" (") + obstacle + ")";
    for (const OpenCell& cell : open) {
      if (!total.is_finite()) break;
      total += range_over(functions[cell.function], cell.sides);
    }
    return because(Undecided{.why = std::move(why), .reached = total, .evaluations = evaluations});
  }
  if (!(total.radius() <= demand.radius)) {
    return because(Undecided{.why = "rounding at " + std::to_string(bits) + " bits is wider than the demand",
                             .reached = total,
                             .evaluations = evaluations});
  }
  return Enclosed{.value = total, .evaluations = evaluations};
}

}  // namespace radcert
