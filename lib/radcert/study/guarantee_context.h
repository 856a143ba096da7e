// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "radcert/core/files/kept_numbers.h"
#include "radcert/study/guarantee.h"

namespace radcert {

/// How far the work on one mesh has come on the way to an enclosure.
struct MeshProgress {
  int layers = 0;
  int degree = 0;
  std::uint64_t elements = 0;
  std::uint64_t planned = 0;  ///< elements whose cells are planned; 0: the functions are being found
  std::uint64_t cells = 0;    ///< 0: not all of them are planned
  std::uint64_t cells_done = 0;
  double width = 0;  ///< of the enclosure from the meshes before; infinite where there was none
};

/// Who is told how far the work on a mesh has come.
/// Requires  may be called by several threads at once
using MeshListener = std::function<void(const MeshProgress&)>;

/// Who is told of the way to an enclosure, and what keeps the parts of it that are done.
struct GuaranteeContext {
  GuaranteeListener progress = {};
  MeshListener meshes = {};     ///< on an ellipsoid there are none
  KeptNumbers* kept = nullptr;  ///< of this problem, guarantee and kind of enclosure alone
};

/// solve_within, told of the work on each mesh too; what an earlier run has kept is not found again.
[[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve_within(const Problem& problem,
                                                                     const Guarantee& guarantee,
                                                                     const GuaranteeContext& context);

}  // namespace radcert
