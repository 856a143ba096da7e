// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/element_side.h"
#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/transport/slid_sizes.h"

namespace radcert {

/// w on the panel beyond an edge, continued across the borders of elements there.
/// Maths     Beside an edge of Q_j, T_j w is as smooth along the edge as w is on Q_j: at borders of elements,
///           which end at the edge, it is not. But w jumps little there, and T_j w = T_j w~ + T_j(w - w~)
///           with a w~ that has no borders near the observers. Those of an element X with the parameters
///           [s0,s1] along the edge look at the column of elements beyond that have the same ends: on each
///           layer of it w~ is the column's polynomial on all of [s0-d, s1+d], and above the column and
///           elsewhere w~ = w. T_j |w - w~|(P) <= sum over the parts A of elements that are continued into of
///           sup_A |w - w~| M(q), q the distance of P from A, M that of EdgeClosure. sup_A is at most the sum
///           of Legendre's coefficients of the difference on A, and w~ has those on [s0-d, s1+d] that bound
///           it where Q slides, see slid_growth
/// Requires  the scene and the elements outlive it
/// Result    bounds rounded up
class EdgeContinuation {
public:
  EdgeContinuation(const SectorScene& scene, std::span<const SectorElement> elements,
                   const SectorFunctions& w);

  /// One d.
  struct Continued {
    /// A part of an element that is continued into.
    struct Part {
      std::array<Vector<double>, 4> corners;
      double difference = 0;  ///< sup |w - w~|
    };
    std::vector<ElementSide> sides;  ///< on Q_j, not parallel to the edge, at which w~ may jump
    SlidSizes sizes{};               ///< sup |w~| on the column
    std::vector<Part> parts;
  };
  /// Of the observers on an element; empty where there is no such column.
  [[nodiscard]] std::span<const Continued> beyond(std::size_t element) const;
  /// sup T_j |w - w~| at points of an element whose convex hull has these corners.
  [[nodiscard]] double rest(const Continued& continued, std::size_t element,
                            std::span<const Vector<double>> hull) const;

private:
  /// Continued beyond one edge, in one column.
  using Column = std::vector<Continued>;
  [[nodiscard]] Continued continued(const SectorFunctions& w, std::span<const std::size_t> column,
                                    const std::vector<ElementSide>& sides, double part) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::vector<Column> columns_;         ///< the first one empty
  std::vector<std::size_t> column_of_;  ///< each element
};

}  // namespace radcert
