// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/scalar/rational.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A coarse triangulation that is cut along visibility events, and what was found of them.
struct EventCut {
  /// Pieces that may reflect more than this part of the largest emission are sources too; absent: none is.
  std::optional<Rational> secondary = std::nullopt;
  std::shared_ptr<const std::vector<ParameterTriangle>> coarse = nullptr;
  std::size_t source_triangles = 0;  ///< of the mesh, that count as sources
  std::size_t pencils = 0;           ///< of lines, that were looked at
  std::size_t segments = 0;          ///< on charts, that they were cut along
  std::size_t kinks = 0;             ///< of these, those across which a first derivative may jump
  std::size_t charts = 0;            ///< that were cut
};

}  // namespace radcert
