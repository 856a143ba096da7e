// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/factors/exchange_area.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// A convex plane polygon that may stand between others: triangles of one plane put together where their
/// union is convex.
struct ConvexOccluder {
  /// Vertices of the scene, counterclockwise as seen from its front, no three in a row on a line.
  FacetCorners corners;
  std::size_t plane = 0;
  std::size_t solid = 0;  ///< occluders of one convex solid, or of one plane, have one number: see FacetScene
  /// Of a convex body: the occluder beyond the side from each corner to the next, if there is one with the
  /// same ends.
  std::vector<std::optional<std::size_t>> beyond_side{};
  /// Of a convex body: all faces that meet in each corner, if they are all occluders, else none.
  std::vector<std::vector<std::size_t>> around_corner{};
};

/// What two triangles see of each other.
enum class PairSight {
  nothing,  ///< in one plane, behind each other, back to back
  whole,    ///< nothing stands between what lies in front of each other's planes
  hidden,   ///< one convex occluder hides each point of one from each of the other
  mixed,    ///< not decided to be any of these: occluders names all that may stand between
};

/// Two triangles, as far as each lies in front of the other's plane.
struct FacetPair {
  PairSight sight = PairSight::nothing;
  FacetCorners first;
  FacetCorners second;
  std::vector<std::size_t> occluders;
};

/// A scene made ready for exchange areas between its triangles.
/// Maths     occluders: the triangles of one oriented plane, joined along their common sides while the union
///           stays convex; left out are those that have the whole scene on one side. solid: the occluders
///           that are faces of one closed convex body, of which light enters through the faces that look at
///           it, once; else those of one plane, which a segment crosses once
/// Source    -
/// Requires  the scene has no faults (scene_faults), else pairs may be called whole that are not
/// Result    pair(): every decision exact for the given doubles; corners that a plane cuts off are rounded.
///           nothing, whole and hidden hold up to sets without area. Symmetric: pair(i, j) and pair(j, i)
///           have the same sight and occluders
/// Limits    mixed says only that no separating plane was found: through a side of one and a corner of the
///           other, or of a polygon itself
class FacetScene {
public:
  explicit FacetScene(TriangleMesh mesh);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] std::size_t facet_count() const { return scene_.triangle_count(); }
  [[nodiscard]] FacetCorners facet(std::size_t triangle) const;
  [[nodiscard]] double area(std::size_t triangle) const { return areas_[triangle]; }
  /// How the triangles fit together, vertices with equal coordinates being one.
  [[nodiscard]] const MeshTopology& topology() const { return topology_; }
  [[nodiscard]] double total_area() const { return total_area_; }
  [[nodiscard]] const std::vector<ConvexOccluder>& occluders() const { return occluders_; }
  /// Whether occluders of one number are faces of a convex body, of which only those that look at a point
  /// hide anything from it.
  [[nodiscard]] bool solid_is_body(std::size_t solid) const { return is_body_[solid]; }
  [[nodiscard]] FacetPair pair(std::size_t first, std::size_t second) const;
  /// Whether a segment between two triangles may meet two occluders: false only where a plane shows that those which meet one of
  /// them, up to a set without measure, pass by the other.
  [[nodiscard]] bool may_hide_together(std::size_t occluder, std::size_t other, std::size_t first,
                                       std::size_t second) const;

private:
  [[nodiscard]] bool may_stand_between(const ConvexOccluder& occluder, std::size_t first,
                                       std::size_t second) const;
  [[nodiscard]] bool hides(const ConvexOccluder& occluder, std::size_t first, std::size_t second) const;
  void find_occluders();
  void find_solids();
  void find_neighbours();

  Scene scene_;
  MeshTopology topology_;
  std::vector<double> areas_;
  double total_area_ = 0;
  std::vector<ConvexOccluder> occluders_;
  std::vector<std::size_t> occluder_triangle_;  ///< a triangle of each
  std::vector<bool> is_body_;
  std::optional<BoxTree> tree_;  ///< of the occluders' boxes
};

}  // namespace radcert
