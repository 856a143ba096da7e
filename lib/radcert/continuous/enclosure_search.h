// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/files/kept_numbers.h"
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
  std::size_t cells = 0;    ///< of a mesh that is not finished; 0: they are not yet planned
  std::size_t cells_done = 0;
  std::size_t planned = 0;  ///< elements whose cells are; 0: the functions of the mesh are being found
};

/// Who is told how far a search has come.
/// Requires  may be called by several threads at once
using EnclosureListener = std::function<void(const EnclosureProgress&)>;

/// Who is told of a search for an enclosure, and what keeps the parts of it that are done.
struct SearchContext {
  EnclosureListener progress = {};
  KeptNumbers* kept = nullptr;  ///< of this problem and width alone
};

/// The work on one mesh of a search.
/// Result    tells of each element whose cells are planned, and how many cells have been looked at, some
///           hundred times; keeps what is found, and finds it
///           again
class MeshWork {
public:
  /// Tells that the mesh has been begun.
  MeshWork(const SearchContext& context, const EnclosureProgress& mesh) : context_(context), mesh_(mesh) {
    mesh_.finished = false;
    if (context_.progress) context_.progress(mesh_);
  }

  /// Cells are planned from the first element on, perhaps once more.
  void begin_plan() { planned_ = 0; }
  /// Those of one more element are planned; by any thread.
  void add_planned() {
    const std::size_t planned = planned_.fetch_add(1) + 1;
    if (!context_.progress) return;
    EnclosureProgress now = mesh_;
    now.planned = planned;
    context_.progress(now);
  }
  void begin(std::size_t cells) { mesh_.cells = cells; }
  /// So many more are done; by any thread.
  void add(std::size_t cells) {
    if (!context_.progress || mesh_.cells == 0) return;
    constexpr std::size_t steps = 200;
    const std::size_t before = done_.fetch_add(cells);
    const std::size_t step = mesh_.cells / steps + 1;
    if (before / step == (before + cells) / step) return;
    EnclosureProgress now = mesh_;
    now.cells_done = before + cells;
    context_.progress(now);
  }

  /// The numbers of a part of the work on this mesh, from an earlier run or from find(), which gives `count`.
  /// Result    the same numbers in either case, if find() gives the same each time
  [[nodiscard]] std::vector<double> numbers(const std::string& part, std::size_t count,
                                            const std::function<std::vector<double>()>& find) const {
    if (context_.kept == nullptr) return find();
    const std::string name = std::to_string(mesh_.layers) + " layers, " + part;
    std::optional<std::vector<double>> kept = context_.kept->find(name);
    if (kept && kept->size() == count) return std::move(*kept);
    std::vector<double> found = find();
    context_.kept->keep(name, found);
    return found;
  }

private:
  const SearchContext& context_;
  EnclosureProgress mesh_;
  std::atomic<std::size_t> planned_ = 0;
  std::atomic<std::size_t> done_ = 0;
};

}  // namespace radcert
