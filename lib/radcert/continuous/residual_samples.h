// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/transport/shaded_values.h"
#include "radcert/continuous/transport/transport.h"
#include "radcert/continuous/trial.h"

namespace radcert {

/// Whether what is shaded from somewhere in a cell is left open, or each sample stands for itself.
enum class ShadedParts { bounded, ignored };

/// T w at the nodes of a cell, or the function near it that the cell's rules are for.
struct CellSamples {
  std::vector<double> values;  ///< by node, function
  double radius = 0;           ///< of values less q
  std::vector<double> shade;   ///< by function: of T w less that function, all over the cell
  std::size_t nodes = 0;
  [[nodiscard]] double largest_shade() const { return largest_shade(shade.size()); }
  /// Of the first functions.
  [[nodiscard]] double largest_shade(std::size_t count) const {
    double largest = 0;
    for (std::size_t k = 0; k < std::min(count, shade.size()); ++k) largest = std::max(largest, shade[k]);
    return largest;
  }
};

/// Of samples, relative to w; none where a cell has no samples.
using CellTolerances = std::vector<std::optional<double>>;

/// What the functions of a trial send to the nodes of cells.
/// Maths     T w_k; next to an edge F of EdgeClosure, what the other panels send and xi times the rest of T 1
///           = 1; where parts are shaded F of Penumbra, what all of the cell sees and constants times the
///           rest
/// Requires  the trial outlives it
/// Result    the same bits for the same cells, which share what distant parts of elements send
class ResidualSamples {
public:
  explicit ResidualSamples(const Trial& trial, ShadedParts shaded = ShadedParts::bounded);

  [[nodiscard]] std::vector<CellSamples> operator()(std::span<const ObserverCell> cells,
                                                    const CellTolerances& tolerances) const;

private:
  [[nodiscard]] std::vector<Transport::Values> sent(std::span<const ObserverCell> cells,
                                                    const CellTolerances& tolerances) const;
  [[nodiscard]] Transport::Values sent_past_panels(const ObserverCell& cell, double tolerance) const;
  [[nodiscard]] std::size_t panel_beyond(std::size_t element) const;
  [[nodiscard]] ShadedValues closed(const ObserverCell& cell, const Transport::Values& found) const;

  const Trial& trial_;
  ShadedParts shaded_;
  SectorFunctions with_one_;
  Transport transport_;
  Transport transport_with_one_;
  std::size_t count_;
};

}  // namespace radcert
