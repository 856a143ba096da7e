// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "radcert/core/work_limit.h"

namespace radcert {

/// Layers of graded_elements up to which a search goes, one after the other.
extern const WorkLimit most_layers;

/// How far a search for an enclosure has come.
struct EnclosureProgress {
  int layers = 0;
  int degree = 0;
  std::size_t elements = 0;
  std::size_t unknowns = 0;
  double mesh_size = 0;     ///< the largest diameter of an element
  std::size_t samples = 0;  ///< points at which residuals were taken, in all
  double width = 0;         ///< of the widest enclosure, so far
  double residual = 0;      ///< a bound of (Int rho t^2)^(1/2), where duality uses it
  bool finished = true;     ///< false while the mesh is being worked on
  std::size_t cells = 0;    ///< of a mesh that is not finished; 0: its functions are being found
  std::size_t cells_done = 0;
};

/// Requires  may be called by several threads at once
using EnclosureListener = std::function<void(const EnclosureProgress&)>;

/// Tells how many cells of a mesh have been looked at, some hundred times.
class CellProgress {
public:
  /// Tells that the mesh has been begun.
  CellProgress(const EnclosureListener& listener, const EnclosureProgress& mesh)
      : listener_(listener), mesh_(mesh) {
    mesh_.finished = false;
    if (listener_) listener_(mesh_);
  }

  void begin(std::size_t cells) { mesh_.cells = cells; }
  /// So many more are done; by any thread.
  void add(std::size_t cells) {
    if (!listener_ || mesh_.cells == 0) return;
    constexpr std::size_t steps = 200;
    const std::size_t before = done_.fetch_add(cells);
    const std::size_t step = mesh_.cells / steps + 1;
    if (before / step == (before + cells) / step) return;
    EnclosureProgress now = mesh_;
    now.cells_done = before + cells;
    listener_(now);
  }

private:
  const EnclosureListener& listener_;
  EnclosureProgress mesh_;
  std::atomic<std::size_t> done_ = 0;
};

}  // namespace radcert
