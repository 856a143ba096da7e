// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A triangle of a chart's parameter plane with the images of its corners.
/// Maths     corners v_1, v_2, v_3, images F_j(v_k)
/// Result    plain data
/// Limits    says nothing of the image between the corners: see deviation
struct SurfaceCell {
  std::size_t chart = 0;
  std::array<ParameterPoint<double>, 3> corners;
  std::array<Vector<double>, 3> images;

  /// The point v_1 + a (v_2 - v_1) + b (v_3 - v_1), moved back into the chart's domain where rounding left
  /// it.
  [[nodiscard]] ParameterPoint<double> at(const Surface& surface, double a, double b) const;
  /// The area in the parameter plane.
  [[nodiscard]] double parameter_area() const;
  /// The longest chord between two corners.
  [[nodiscard]] double longest_chord() const;
  /// The largest distance of a side's middle from its chord's middle; 0 on a plane chart, about a sagitta on
  /// a small cell of a curved one.
  [[nodiscard]] double deviation(const Surface& surface) const;
  /// The two halves, cut through the parameter middle of the side with the longest chord.
  [[nodiscard]] std::pair<SurfaceCell, SurfaceCell> halves(const Surface& surface) const;
};

/// A surface in cells smaller than a length.
/// Maths     cells with longest chord < h, by halving those of the coarse triangulation
/// Source    bisection of the longest side, which cuts slivers across
/// Requires  h > 0, else ContractViolation
/// Result    chart by chart, the same order on every machine; nothing, if there would be more than `most`
/// Limits    charts that are not plane are divided four times before chords are looked at
[[nodiscard]] std::optional<std::vector<SurfaceCell>> cells_below(const Surface& surface, double h,
                                                                  std::size_t most);

}  // namespace radcert
