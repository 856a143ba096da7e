// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// An element of a polyhedron: a rectangle of a sector's parameters.
struct SectorElement {
  std::size_t sector = 0;
  SectorBox box;
};

/// Where a part of an interval lies in it, both as seen from [-1,1].
struct PartOfInterval {
  double middle = 0;
  double half = 1;
  [[nodiscard]] double place(double x) const { return middle + half * x; }
};

/// Where a box lies in another that holds it, in the first and in the second parameter of the sector.
[[nodiscard]] PartOfInterval part_in_s(const SectorBox& part, const SectorBox& whole);
[[nodiscard]] PartOfInterval part_in_t(const SectorBox& part, const SectorBox& whole);

/// Elements that shrink towards edges and vertices.
/// Maths     layers of t between 0, 4^-(L-1), ..., 1/4, 1; the layer below 4^-l is cut at s = 4^-k/2 and 1 -
///           4^-k/2, k = 0, ..., l: L(L+1) elements a sector. Both sides of an edge have the same points
/// Source    geometric meshes of hp methods: C. Schwab, "p- and hp-Finite Element Methods", 1998
/// Requires  1 <= layers <= 12, else ContractViolation
/// Result    in the order of the sectors
[[nodiscard]] std::vector<SectorElement> graded_elements(const SectorScene& scene, int layers);

/// The largest diameter of an element, rounded.
[[nodiscard]] double mesh_size(const SectorScene& scene, std::span<const SectorElement> elements);

}  // namespace radcert
