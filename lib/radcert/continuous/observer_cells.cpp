// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/observer_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit deepest_cell("continuous/observer_cells: halvings of an element", 80, 0,
                             "a strip that is not looked into");

const WorkLimit most_cells("continuous/observer_cells: cells of an element", 20000, 0,
                           "strips that are not looked into");

namespace {

/// A cell whose rule would need more is cut.
constexpr int most_cell_nodes = 12;

/// The cells of one element.
class ElementCells {
public:
  ElementCells(const Trial& trial, std::size_t number, const CellDemand& demand)
      : sector_(trial.sector(number)),
        number_(number),
        smoothness_(trial.smoothness),
        closure_(trial.closure),
        demand_(demand) {
    add(trial.elements[number].box, 0);
  }
  std::vector<ObserverCell> take() && { return std::move(cells_); }

private:
  /// Takes the cell where rules meet the demand, with what `beside` bounds where the cell is closed.
  bool accept(const SectorBox& box, double area, const RuleErrors& in_s, const RuleErrors& in_t,
              std::optional<double> beside) {
    const double more = beside.value_or(0);
    const double density = smoothness_.density_size(number_);
    if (!(0.5 * more * std::sqrt(area) <= 0.25 * demand_.interpolation &&
          more * density * area <= 0.5 * demand_.quadrature))
      return false;
    const int nodes_s = nodes(in_s, area);
    const int nodes_t = nodes(in_t, area);
    if (nodes_s == 0 || nodes_t == 0) return false;
    const auto s = static_cast<std::size_t>(nodes_s - 1);
    const auto t = static_cast<std::size_t>(nodes_t - 1);
    cells_.push_back({.element = number_,
                      .box = box,
                      .nodes_s = nodes_s,
                      .nodes_t = nodes_t,
                      .closed = beside.has_value(),
                      .interpolation = in_s.interpolation[s] + in_t.interpolation[t] + 0.5 * more,
                      .quadrature = in_s.quadrature[s] + in_t.quadrature[t] + more * density});
    return true;
  }

  void add(const SectorBox& box, long depth_of_cuts) {
    const double area = sector_.jacobian * box.weight();
    const bool at_edge = box.t0 == 0;
    const double largest = smoothness_.residual_size(number_);
    const bool small = largest * std::sqrt(area) <= demand_.interpolation &&
                       area * smoothness_.density_size(number_) * largest <= demand_.quadrature;
    if (small || depth_of_cuts >= deepest_cell.value() || cells_.size() >= most_cells.count()) {
      cells_.push_back({.element = number_, .box = box});
      return;
    }
    SectorBox lower = box;
    SectorBox upper = box;
    const bool closes = at_edge && closure_.mirror(number_).has_value();
    if (at_edge) {
      const EdgeClosure::Nearby nearby = closes ? closure_.nearby(number_, box) : EdgeClosure::Nearby{};
      if (closes && accept(box, area, smoothness_.along_s(number_, box, true),
                           smoothness_.along_t(number_, box, true), nearby.bound))
        return;
      const double length = (box.s1 - box.s0) * norm(sector_.b - sector_.a);
      const double depth = box.t1 * norm(sector_.c - sector_.point(box.middle_s(), 0));
      if (closes && length > nearby.distance && length > 4 * depth) {
        lower.s1 = upper.s0 = box.middle_s();
        add(lower, depth_of_cuts + 1);
        add(upper, depth_of_cuts + 1);
        return;
      }
      lower.t1 = upper.t0 = box.t1 / 4;
      add(lower, depth_of_cuts + 2);
      add(upper, depth_of_cuts + 1);
      return;
    }
    const RuleErrors in_s = smoothness_.along_s(number_, box, false);
    const RuleErrors in_t = smoothness_.along_t(number_, box, false);
    if (accept(box, area, in_s, in_t, std::nullopt)) return;
    const int nodes_s = nodes(in_s, area);
    const int nodes_t = nodes(in_t, area);
    const bool cut_s = nodes_s == 0 && (nodes_t > 0 || box.s1 - box.s0 >= box.t1 - box.t0);
    if (cut_s)
      lower.s1 = upper.s0 = box.middle_s();
    else
      lower.t1 = upper.t0 = box.middle_t();
    add(lower, depth_of_cuts + 1);
    add(upper, depth_of_cuts + 1);
  }

  /// The least number of nodes that meets half the demand; 0 where there is none.
  [[nodiscard]] int nodes(const RuleErrors& errors, double area) const {
    for (int n = 1; n <= most_cell_nodes; ++n) {
      const auto k = static_cast<std::size_t>(n - 1);
      if (errors.interpolation[k] * std::sqrt(area) <= 0.5 * demand_.interpolation &&
          errors.quadrature[k] * area <= 0.5 * demand_.quadrature)
        return n;
    }
    return 0;
  }

  const Sector& sector_;
  std::size_t number_;
  const Smoothness& smoothness_;
  const EdgeClosure& closure_;
  const CellDemand& demand_;
  std::vector<ObserverCell> cells_;
};

}  // namespace

std::vector<ObserverCell> observer_cells(const Trial& trial, const CellDemand& demand) {
  return parallel_reduce_ordered(
      trial.elements.size(), 1, std::vector<ObserverCell>(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<ObserverCell> cells;
        for (std::size_t e = begin; e < end; ++e) {
          std::vector<ObserverCell> own = ElementCells(trial, e, demand).take();
          cells.insert(cells.end(), own.begin(), own.end());
        }
        return cells;
      },
      [](std::vector<ObserverCell> all, std::vector<ObserverCell> more) {
        all.insert(all.end(), more.begin(), more.end());
        return all;
      });
}

}  // namespace radcert
