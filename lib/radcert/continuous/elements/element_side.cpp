// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_side.h"

#include <algorithm>
#include <limits>

namespace radcert {

std::vector<ElementSide> sides_across(const SectorScene& scene, std::span<const SectorElement> elements,
                                      std::size_t sector, std::size_t panel) {
  std::vector<ElementSide> sides;
  for (const SectorElement& element : elements) {
    if (scene.sectors()[element.sector].panel != panel) continue;
    const SectorBox& b = element.box;
    const auto add = [&](const SectorBox& side) { sides.push_back(side_of(scene, element.sector, side)); };
    add({.s0 = b.s0, .s1 = b.s0, .t0 = b.t0, .t1 = b.t1});
    add({.s0 = b.s1, .s1 = b.s1, .t0 = b.t0, .t1 = b.t1});
    if (scene.aligned(sector, element.sector)) continue;
    add({.s0 = b.s0, .s1 = b.s1, .t0 = b.t0, .t1 = b.t0});
    add({.s0 = b.s0, .s1 = b.s1, .t0 = b.t1, .t1 = b.t1});
  }
  return sides;
}

double least_distance(const Vector<double>& point, std::span<const ElementSide> sides) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const ElementSide& side : sides) nearest = std::min(nearest, distance(point, side.from, side.to));
  return nearest;
}

}  // namespace radcert
