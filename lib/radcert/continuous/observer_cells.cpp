// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/observer_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "radcert/continuous/occlusion/penumbra.h"
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

/// When a cell is good enough, and where it need not be.
class CellJudge {
public:
  CellJudge(const Trial& trial, std::size_t number)
      : sector_(trial.sector(number)),
        density_(trial.smoothness.density_size(number)),
        residual_(trial.smoothness.residual_size(number)) {}
  CellJudge(const CellJudge&) = delete;
  CellJudge& operator=(const CellJudge&) = delete;
  CellJudge(CellJudge&&) = delete;
  CellJudge& operator=(CellJudge&&) = delete;
  virtual ~CellJudge() = default;

  [[nodiscard]] virtual bool may_be_strip(const SectorBox& box) const = 0;
  /// Whether n nodes in one variable are enough.
  [[nodiscard]] virtual bool are_enough(const RuleErrors& errors, int n, const SectorBox& box) const = 0;
  /// Whether what a closure at an edge leaves is little.
  [[nodiscard]] virtual bool is_little(const EdgeClosure::Nearby& beside, const SectorBox& box) const = 0;
  /// Whether jumps of w may stay in a cell.
  [[nodiscard]] virtual bool takes_jumps() const = 0;
  /// Whether what is shaded leaves little.
  [[nodiscard]] virtual bool is_in_the_light(const ObserverCell& cell) const = 0;
  /// What may be left of |T w|, about.
  [[nodiscard]] virtual double allowed_shade(const SectorBox& box) const = 0;

protected:
  [[nodiscard]] double area(const SectorBox& box) const { return sector_.jacobian * box.weight(); }
  const Sector& sector_;
  double density_;
  double residual_;
};

/// In the mean.
class MeanJudge final : public CellJudge {
public:
  MeanJudge(const Trial& trial, std::size_t number, const CellDemand& demand)
      : CellJudge(trial, number), demand_(demand) {}
  [[nodiscard]] bool may_be_strip(const SectorBox& box) const override {
    return residual_ * std::sqrt(area(box)) <= demand_.interpolation &&
           area(box) * density_ * residual_ <= demand_.quadrature;
  }
  [[nodiscard]] bool are_enough(const RuleErrors& errors, int n, const SectorBox& box) const override {
    const auto k = static_cast<std::size_t>(n - 1);
    return errors.interpolation[k] * std::sqrt(area(box)) <= 0.5 * demand_.interpolation &&
           errors.quadrature[k] * area(box) <= 0.5 * demand_.quadrature;
  }
  [[nodiscard]] bool is_little(const EdgeClosure::Nearby& beside, const SectorBox& box) const override {
    return 0.5 * beside.bound * std::sqrt(area(box)) <= 0.25 * demand_.interpolation &&
           beside.bound * density_ * area(box) <= 0.5 * demand_.quadrature;
  }
  [[nodiscard]] bool takes_jumps() const override { return false; }
  [[nodiscard]] bool is_in_the_light(const ObserverCell& cell) const override {
    return 0.5 * cell.shade * std::sqrt(area(cell.box)) <= demand_.interpolation &&
           cell.shade_of_mean * area(cell.box) <= demand_.shade;
  }
  [[nodiscard]] double allowed_shade(const SectorBox& box) const override {
    return std::min(2 * demand_.interpolation / std::sqrt(area(box)), demand_.shade / (density_ * area(box)));
  }

private:
  const CellDemand& demand_;
};

/// In the maximum norm.
class LargestJudge final : public CellJudge {
public:
  LargestJudge(const Trial& trial, std::size_t number, const LargestDemand& demand)
      : CellJudge(trial, number), demand_(demand), number_(number) {}
  [[nodiscard]] bool may_be_strip(const SectorBox& box) const override {
    return !(allowed(box) < std::numeric_limits<double>::infinity()) || demand_.may_be_strip(sector_, box);
  }
  [[nodiscard]] bool are_enough(const RuleErrors& errors, int n, const SectorBox& box) const override {
    return interpolation_error(errors.interpolation[static_cast<std::size_t>(n - 1)], n, 0, n) <=
           0.25 * allowed(box);
  }
  [[nodiscard]] bool is_little(const EdgeClosure::Nearby& beside, const SectorBox& box) const override {
    return beside.bound - beside.jumps <= 0.5 * allowed(box);
  }
  [[nodiscard]] bool takes_jumps() const override { return true; }
  [[nodiscard]] bool is_in_the_light(const ObserverCell& cell) const override {
    return cell.shade <= 0.5 * allowed(cell.box);
  }
  [[nodiscard]] double allowed_shade(const SectorBox& box) const override { return 0.5 * allowed(box); }

private:
  [[nodiscard]] double allowed(const SectorBox& box) const { return demand_.allowed(number_, sector_, box); }
  const LargestDemand& demand_;
  std::size_t number_;
};

/// The cells of one element.
class ElementCells {
public:
  ElementCells(const Trial& trial, std::size_t number, const CellJudge& judge)
      : trial_(trial),
        sector_(trial.sector(number)),
        number_(number),
        smoothness_(trial.smoothness),
        closure_(trial.closure),
        judge_(judge) {
    for (std::size_t j = 0; j < trial.scene.panels().size(); ++j)
      if (trial.scene.touching(trial.elements[number].sector, j) &&
          trial.scene.sight().view(sector_.panel, j) != PanelView::none)
        is_at_edge_ = true;
    const bool is_open = trial.scene.sight().is_open();
    add(trial.elements[number].box, 0,
        is_open ? std::vector<PartOfElement>{} : trial.penumbra.may_be_shaded(sector_.panel));
  }
  std::vector<ObserverCell> take() && { return std::move(cells_); }

private:
  enum class Judgement { taken, needs_rules, is_shaded };

  /// Takes the cell where rules are enough, with what `beside` leaves where the cell is closed. Of the parts
  /// that may be shaded those are left which are, where it is only for them that it is not taken.
  Judgement accept(const SectorBox& box, const RuleErrors& in_s, const RuleErrors& in_t,
                   std::optional<EdgeClosure::Nearby> beside, std::vector<PartOfElement>& may_be_shaded) {
    if (beside && !judge_.is_little(*beside, box)) return Judgement::needs_rules;
    const int nodes_s = nodes(in_s, box);
    const int nodes_t = nodes(in_t, box);
    if (nodes_s == 0 || nodes_t == 0) return Judgement::needs_rules;
    const double more = beside ? beside->bound : 0;
    const auto s = static_cast<std::size_t>(nodes_s - 1);
    const auto t = static_cast<std::size_t>(nodes_t - 1);
    ObserverCell cell{
        .element = number_,
        .box = box,
        .nodes_s = nodes_s,
        .nodes_t = nodes_t,
        .closed = beside.has_value(),
        .of_interpolant = interpolation_error(in_s.interpolation[s], nodes_s, in_t.interpolation[t], nodes_t),
        .beside = more,
        .interpolation = in_s.interpolation[s] + in_t.interpolation[t] + 0.5 * more,
        .quadrature = in_s.quadrature[s] + in_t.quadrature[t] + more * smoothness_.density_size(number_)};
    if (!trial_.scene.sight().is_open()) {
      cell.least_mass = 0.02 * judge_.allowed_shade(box);
      std::vector<PartOfElement> shaded = put_shade(cell, may_be_shaded);
      if (!judge_.is_in_the_light(cell)) {
        may_be_shaded = std::move(shaded);
        return Judgement::is_shaded;
      }
    }
    cells_.push_back(cell);
    return Judgement::taken;
  }

  /// Result    the parts that are shaded
  std::vector<PartOfElement> put_shade(ObserverCell& cell, std::span<const PartOfElement> parts) const {
    const std::array<Vector<double>, 4> hull = corners_of(sector_, cell.box);
    std::vector<ShadedPart> shaded = trial_.penumbra.shaded(sector_.panel, hull, parts, cell.least_mass);
    std::vector<PartOfElement> left;
    for (const ShadedPart& own : shaded) left.push_back(own.part);
    if (const std::optional<std::size_t> mirror = closure_.mirror(number_); cell.closed && mirror) {
      const std::size_t beyond = trial_.sector(*mirror).panel;
      std::erase_if(shaded,
                    [&](const ShadedPart& own) { return trial_.sector(own.part.element).panel == beyond; });
    }
    if (shaded.empty()) return left;
    const std::vector<double> bounds = trial_.penumbra.rest(shaded).bounds;
    cell.shade = *std::max_element(bounds.begin(), bounds.end());
    double largest = 0;
    for (std::size_t k = 0; k < bounds.size(); ++k)
      largest = std::max(largest, trial_.penumbra.size(number_, k));
    cell.shade_of_mean = bounds[0] * largest;
    return left;
  }

  /// Cuts the longer sides of a cell.
  void halve(const SectorBox& box, long depth_of_cuts, std::vector<PartOfElement> may_be_shaded) {
    const auto [lower, upper] = halves(sector_, box);
    add(lower, depth_of_cuts + 1, may_be_shaded);
    add(upper, depth_of_cuts + 1, std::move(may_be_shaded));
  }

  void add(const SectorBox& box, long depth_of_cuts, std::vector<PartOfElement> may_be_shaded) {
    const bool at_edge = box.t0 == 0 && is_at_edge_;
    if (judge_.may_be_strip(box) || depth_of_cuts >= deepest_cell.value() ||
        cells_.size() >= most_cells.count()) {
      cells_.push_back({.element = number_, .box = box});
      return;
    }
    SectorBox lower = box;
    SectorBox upper = box;
    const bool closes = at_edge && closure_.mirror(number_).has_value();
    Judgement judgement = Judgement::needs_rules;
    if (at_edge) {
      bool is_too_long = false;
      EdgeClosure::Nearby nearby = closes ? closure_.nearby(number_, box) : EdgeClosure::Nearby{};
      if (closes) {
        const RuleErrors in_s = smoothness_.along_s(number_, box, true);
        const RuleErrors in_t = smoothness_.along_t(number_, box, true);
        judgement = accept(box, in_s, in_t, nearby, may_be_shaded);
        if (judgement == Judgement::needs_rules && judge_.takes_jumps()) {
          nearby = closure_.nearby_across_borders(number_, box);
          judgement = accept(box, in_s, in_t, nearby, may_be_shaded);
        }
        if (judgement == Judgement::taken) return;
        if (judgement == Judgement::is_shaded) {
          halve(box, depth_of_cuts, std::move(may_be_shaded));
          return;
        }
        is_too_long = judge_.is_little(nearby, box) && nodes(in_s, box) == 0;
      }
      const double length = (box.s1 - box.s0) * norm(sector_.b - sector_.a);
      const double depth = box.t1 * norm(sector_.c - sector_.point(box.middle_s(), 0));
      const bool may_close_when_short =
          closes && length > nearby.distance && length > 4 * depth &&
          (!judge_.takes_jumps() ||
           judge_.is_little(closure_.nearby_across_borders(number_, middle_of(box)), box));
      if (may_close_when_short || (is_too_long && length > depth)) {
        lower.s1 = upper.s0 = box.middle_s();
        add(lower, depth_of_cuts + 1, may_be_shaded);
        add(upper, depth_of_cuts + 1, std::move(may_be_shaded));
        return;
      }
      lower.t1 = upper.t0 = box.t1 / 4;
      add(lower, depth_of_cuts + 2, may_be_shaded);
      add(upper, depth_of_cuts + 1, std::move(may_be_shaded));
      return;
    }
    const RuleErrors in_s = smoothness_.along_s(number_, box, false);
    const RuleErrors in_t = smoothness_.along_t(number_, box, false);
    judgement = accept(box, in_s, in_t, std::nullopt, may_be_shaded);
    if (judgement == Judgement::taken) return;
    if (judgement == Judgement::is_shaded) {
      halve(box, depth_of_cuts, std::move(may_be_shaded));
      return;
    }
    const int nodes_s = nodes(in_s, box);
    const int nodes_t = nodes(in_t, box);
    const bool cut_s = nodes_s == 0 && (nodes_t > 0 || box.s1 - box.s0 >= box.t1 - box.t0);
    if (cut_s)
      lower.s1 = upper.s0 = box.middle_s();
    else
      lower.t1 = upper.t0 = box.middle_t();
    add(lower, depth_of_cuts + 1, may_be_shaded);
    add(upper, depth_of_cuts + 1, std::move(may_be_shaded));
  }

  /// A part that is so short that its length does not matter.
  [[nodiscard]] static SectorBox middle_of(const SectorBox& box) {
    const double half = 0x1p-10 * (box.s1 - box.s0);
    return {.s0 = box.middle_s() - half, .s1 = box.middle_s() + half, .t0 = box.t0, .t1 = box.t1};
  }

  /// The least number of nodes that is enough; 0 where there is none.
  [[nodiscard]] int nodes(const RuleErrors& errors, const SectorBox& box) const {
    for (int n = 1; n <= most_cell_nodes; ++n)
      if (judge_.are_enough(errors, n, box)) return n;
    return 0;
  }

  const Trial& trial_;
  const Sector& sector_;
  std::size_t number_;
  bool is_at_edge_ = false;  ///< whether a panel that may be seen touches the side of the sector
  const Smoothness& smoothness_;
  const EdgeClosure& closure_;
  const CellJudge& judge_;
  std::vector<ObserverCell> cells_;
};

template <class Judge, class Demand>
std::vector<ObserverCell> cells_of(const Trial& trial, const Demand& demand,
                                   const std::function<void()>& planned) {
  return parallel_reduce_ordered(
      trial.elements.size(), 1, std::vector<ObserverCell>(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<ObserverCell> cells;
        for (std::size_t e = begin; e < end; ++e) {
          std::vector<ObserverCell> own = ElementCells(trial, e, Judge(trial, e, demand)).take();
          cells.insert(cells.end(), own.begin(), own.end());
          if (planned) planned();
        }
        return cells;
      },
      [](std::vector<ObserverCell> all, std::vector<ObserverCell> more) {
        all.insert(all.end(), more.begin(), more.end());
        return all;
      });
}

}  // namespace

std::vector<ObserverCell> observer_cells(const Trial& trial, const CellDemand& demand,
                                         const std::function<void()>& planned) {
  return cells_of<MeanJudge>(trial, demand, planned);
}

std::vector<ObserverCell> observer_cells(const Trial& trial, const LargestDemand& demand,
                                         const std::function<void()>& planned) {
  return cells_of<LargestJudge>(trial, demand, planned);
}

}  // namespace radcert
