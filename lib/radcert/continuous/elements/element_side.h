// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// A side of an element: a box of a sector's parameters that has no width in one of them.
struct ElementSide {
  std::size_t sector = 0;
  SectorBox box;
  Vector<double> from;
  Vector<double> to;
};

/// The side between two places of a sector.
/// Result    ends within displacement of the exact ones
[[nodiscard]] inline ElementSide side_of(const SectorScene& scene, std::size_t sector, const SectorBox& box) {
  const Sector& on = scene.sectors()[sector];
  return {sector, box, on.point(box.s0, box.t0), on.point(box.s1, box.t1)};
}

/// The sides of the elements on a panel that are not parallel to a sector's side.
/// Requires  a panel that the side of the sector is parallel to
/// Result    in the order of the elements; those that two elements share twice
[[nodiscard]] std::vector<ElementSide> sides_across(const SectorScene& scene,
                                                    std::span<const SectorElement> elements,
                                                    std::size_t sector, std::size_t panel);

/// The least distance of a point from sides, rounded; infinite where there are none.
[[nodiscard]] double least_distance(const Vector<double>& point, std::span<const ElementSide> sides);

}  // namespace radcert
