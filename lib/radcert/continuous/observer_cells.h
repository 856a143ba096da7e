// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/trial.h"

namespace radcert {

/// A part of an element, and the rule of its observers.
struct ObserverCell {
  std::size_t element = 0;
  SectorBox box;
  int nodes_s = 0;  ///< 0: so small that it is not looked into
  int nodes_t = 0;
  bool closed = false;        ///< at an edge: T w = F + what is in the bounds below
  double of_interpolant = 0;  ///< of F less its interpolant: interpolation_error
  double beside = 0;          ///< of |T w - F|, where it is closed
  double interpolation = 0;   ///< the sum of both variables' RuleErrors of interpolation, and half of beside
  double quadrature = 0;
  double shade = 0;          ///< of |T w - F|, F of Penumbra, for all functions
  double least_mass = 0;     ///< of a shaded part that is worth halving
  double shade_of_mean = 0;  ///< of the means of w_k (T w_0 - F_0)
  [[nodiscard]] bool is_strip() const { return nodes_s == 0; }
};

/// What a cell X may contribute.
/// Maths     interpolation: e sqrt|X|; quadrature: |X| times the bound for the mean. A cell that is not
///           looked into contributes sup|T w - q| sqrt|X| and |X| sup|w| sup|T w - q|. Shade: |X| times
///           shade_of_mean, and half of `shade` beside e
struct CellDemand {
  double interpolation = 0;
  double quadrature = 0;
  double shade = 0;
};

/// What the rules of a cell may miss in the maximum norm, and which cells need not be looked into.
class LargestDemand {
public:
  LargestDemand() = default;
  LargestDemand(const LargestDemand&) = delete;
  LargestDemand& operator=(const LargestDemand&) = delete;
  LargestDemand(LargestDemand&&) = delete;
  LargestDemand& operator=(LargestDemand&&) = delete;
  virtual ~LargestDemand() = default;

  /// On a part of an element, which is on this sector; infinite where nothing is to be looked into.
  [[nodiscard]] virtual double allowed(std::size_t element, const Sector& sector,
                                       const SectorBox& box) const = 0;
  [[nodiscard]] virtual bool may_be_strip(const Sector& sector, const SectorBox& box) const = 0;
};

/// sup |f - I f|, I the interpolation at a cell's nodes.
/// Maths     |f - I_s I_t f| <= |f - I_s f| + |I_s (f - I_t f)| <= (1+L_s) e_s + L_s (1+L_t) e_t, L the
///           Lebesgue constants; or the other variable first
[[nodiscard]] inline double interpolation_error(double e_s, int nodes_s, double e_t, int nodes_t) {
  const double of_s = (1 + lebesgue_constant(nodes_s)) * e_s;
  const double of_t = (1 + lebesgue_constant(nodes_t)) * e_t;
  return std::min(of_s + lebesgue_constant(nodes_s) * of_t, of_t + lebesgue_constant(nodes_t) * of_s) *
         upward;
}

/// Cells with rules that meet a demand.
/// Maths     an element is cut until rules of most_gauss_nodes or fewer do, or none is needed; a part that
///           touches its edge of the polyhedron is cut at a quarter of its depth
/// Result    by element; deterministic; `planned` is called once an element, by any thread
[[nodiscard]] std::vector<ObserverCell> observer_cells(const Trial& trial, const CellDemand& demand,
                                                       const std::function<void()>& planned = {});

/// Cells with rules that meet a demand in the maximum norm.
/// Maths     interpolation_error is about what is allowed, and less what the closure at an edge
///           leaves beside the jumps of w across borders, which no smaller cell would leave out
/// Result    as above
[[nodiscard]] std::vector<ObserverCell> observer_cells(const Trial& trial, const LargestDemand& demand,
                                                       const std::function<void()>& planned = {});

}  // namespace radcert
