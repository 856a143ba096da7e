// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/trial.h"

namespace radcert {

/// A part of an element, and the rule of its observers.
struct ObserverCell {
  std::size_t element = 0;
  SectorBox box;
  int nodes_s = 0;  ///< 0: so small that it is not looked into
  int nodes_t = 0;
  bool closed = false;       ///< at an edge: T w = F + what is in the bounds below
  double interpolation = 0;  ///< the sum of both variables' RuleErrors
  double quadrature = 0;
  [[nodiscard]] bool is_strip() const { return nodes_s == 0; }
};

/// What a cell X may contribute.
/// Maths     interpolation: e sqrt|X|; quadrature: |X| times the bound for the mean. A cell that is not
///           looked into contributes sup|T w - q| sqrt|X| and |X| sup|w| sup|T w - q|
struct CellDemand {
  double interpolation = 0;
  double quadrature = 0;
};

/// Cells with rules that meet a demand.
/// Maths     an element is cut until rules of most_gauss_nodes or fewer do, or none is needed; a part that
///           touches its edge of the polyhedron is cut at a quarter of its depth
/// Result    by element; deterministic
[[nodiscard]] std::vector<ObserverCell> observer_cells(const Trial& trial, const CellDemand& demand);

}  // namespace radcert
