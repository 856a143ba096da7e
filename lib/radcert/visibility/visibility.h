// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "radcert/geometry/vector.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// A point of a scene: the doubles are the exact coordinates.
struct ScenePoint {
  Vector<double> at;
  /// The triangle that the point was taken from, if any; rounding may have put the point beside its plane.
  std::optional<std::size_t> triangle;
};

/// Whether two points of a scene see each other.
/// Maths     V(P,Q) = 0 where the open segment PQ has a point in common with a closed triangle of the scene
///           that lies neither in the plane of P's triangle nor in that of Q's, or where one of the points
///           lies strictly behind the other's triangle, unless both triangles lie in one plane; else 1. So an
///           end may lie on a triangle (touching hides nothing), a segment through a side or a vertex is
///           hidden (grazing hides), and one within a triangle's plane is hidden where it meets that
///           triangle. P = Q: 1
/// Source    [ac98, section 1], whose V hides by all of S: then points of one plane never see each other,
///           where G = 0 anyway. With rounded points it would hide more than that: a plane that a point was
///           taken from hides nothing here
/// Requires  coordinates of at most Scene::largest_coordinate, triangles that are there, else
///           ContractViolation
/// Result    exact for the given doubles, symmetric in P and Q. A point without a triangle has no back
/// Limits    a point rounded to the far side of another wall, next to an edge, is hidden by that wall
[[nodiscard]] bool visible(const Scene& scene, const ScenePoint& p, const ScenePoint& q);

/// The triangle that hides them: the first that the search meets, if any; one behind whose back the other
/// lies counts.
[[nodiscard]] std::optional<std::size_t> blocker(const Scene& scene, const ScenePoint& p,
                                                 const ScenePoint& q);

}  // namespace radcert
