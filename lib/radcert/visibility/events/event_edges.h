// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/visibility/scene.h"

namespace radcert {

/// A triangle's side as an edge of a closed scene.
struct EventEdge {
  std::size_t from = 0;  ///< the smaller number of its vertices, as Scene::vertices has them
  std::size_t to = 0;
  std::vector<std::size_t> triangles;  ///< that have it as a side: two, or more where bodies touch
  std::vector<std::size_t> opposite;   ///< the third vertex of each
  bool flat = false;                   ///< two triangles in one plane
  bool convex = false;  ///< a line in free space may touch it: the second triangle is behind the first
  bool source = false;  ///< the border of a source
};

/// The edges and vertices of a closed scene at which visibility may change.
/// Maths     an edge is convex where the body is, so that lines in free space touch it. A vertex in the
///           middle of a straight edge, or within a face, is none at which anything changes
/// Requires  source: one entry a triangle, as EventQuestion::source has them; an even number of triangles at
///           each edge, else ContractViolation
/// Result    exact; edges in the order of their vertices
/// Limits    an edge of four triangles or more, where bodies touch, counts as convex
struct EventEdges {
  std::vector<EventEdge> edges;
  std::vector<std::size_t>
      corners;  ///< vertices at which edges end or turn that are not flat, or of a source
  std::vector<std::vector<std::size_t>> triangles_at;  ///< by vertex

  EventEdges(const Scene& scene, std::span<const std::optional<std::size_t>> source);
  /// Whether an edge is one that sight or light changes at.
  [[nodiscard]] static bool counts(const EventEdge& edge) { return edge.source || !edge.flat; }
};

}  // namespace radcert
