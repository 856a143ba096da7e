// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

/// How two triangles see each other.
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
  Vector<double> first_normal;  ///< of unit length, from the exact corners
  Vector<double> second_normal;
  std::vector<std::size_t> occluders;
};

/// Why doubles cannot carry exchange areas of a mesh, if so.
/// Maths     products of six lengths, and of two areas over a squared length, must not leave the range of
///           doubles
/// Source    IEEE 754
/// Requires  finite coordinates, at least one triangle, none degenerate
/// Result    words with numbers where the box about all triangles is longer than 2^100 or shorter than 2^-100
///           in all directions, or where a triangle has less than 2^-200 of the square of that length; exact
///           but for a factor of 2
[[nodiscard]] std::optional<std::string> beyond_doubles(const TriangleMesh& mesh);

/// A scene made ready for exchange areas between its triangles.
/// Maths     occluders: the triangles of one oriented plane, joined along their common sides while the union
///           stays convex; left out are those that have the whole scene on one side. solid: the occluders
///           that are faces of one closed convex body, of which light enters through the faces that look at
///           it, once; else those of one plane, which a segment crosses once. A triangle that crosses no body
///           lies in it or outside: in it, if no corner is in front of a face's plane and not all are in the
///           plane. From outside to inside each segment meets the body's surface: the pair is hidden; between
///           two points inside none does, for the body is convex: its faces are no occluders of the pair
/// Requires  at least one triangle, !beyond_doubles(mesh) and unit > 0, else ContractViolation; no faults
///           (scene_faults) but doubled triangles that run against each other, the two sides of a plate, else
///           pairs may be called whole that are not
/// Result    pair(): every decision exact for the given doubles; corners that a plane cuts off are rounded.
///           nothing, whole and hidden hold up to sets without area. Symmetric: pair(i, j) and pair(j, i)
///           have the same sight and occluders
/// Limits    mixed says only that no separating plane was found: through a side of one and a corner of the
///           other, or of a polygon itself
class FacetScene {
public:
  /// `unit`: the length that the coordinates count, see FactorMesh.
  explicit FacetScene(TriangleMesh mesh, Rational unit = 1);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] std::size_t facet_count() const { return scene_.triangle_count(); }
  [[nodiscard]] FacetCorners facet(std::size_t triangle) const;
  [[nodiscard]] double area(std::size_t triangle) const { return areas_[triangle]; }
  /// From the exact corners, rounded: that of a sliver too.
  [[nodiscard]] const Vector<double>& unit_normal(std::size_t triangle) const {
    return unit_normals_[triangle];
  }
  /// How the triangles fit together, vertices with equal coordinates being one.
  [[nodiscard]] const MeshTopology& topology() const { return topology_; }
  [[nodiscard]] double total_area() const { return total_area_; }
  /// Points, areas and exchange areas of the scene are in its coordinates, lengths in multiples of this.
  [[nodiscard]] const Rational& unit() const { return unit_; }
  [[nodiscard]] const std::vector<ConvexOccluder>& occluders() const { return occluders_; }
  /// Whether occluders of one number are faces of a convex body, of which only those that look at a point
  /// hide anything from it.
  [[nodiscard]] bool solid_is_body(std::size_t solid) const { return is_body_[solid]; }
  /// One of the triangles that make up an occluder.
  [[nodiscard]] std::size_t triangle_of_occluder(std::size_t occluder) const {
    return occluder_triangle_[occluder];
  }
  /// Whether a triangle lies in a convex body; of one that crosses its surface this says nothing.
  [[nodiscard]] bool lies_within(std::size_t triangle, std::size_t solid) const;
  [[nodiscard]] const std::vector<std::size_t>& bodies_of(std::size_t triangle) const {
    return bodies_of_[triangle];
  }
  [[nodiscard]] FacetPair pair(std::size_t first, std::size_t second) const;
  /// Whether a segment between two triangles may meet two occluders: false only where a plane shows that
  /// those which meet one of them, up to a set without measure, pass by the other.
  [[nodiscard]] bool may_hide_together(std::size_t occluder, std::size_t other, std::size_t first,
                                       std::size_t second) const;

private:
  [[nodiscard]] bool may_stand_between(const ConvexOccluder& occluder, std::size_t first,
                                       std::size_t second) const;
  [[nodiscard]] bool hides(const ConvexOccluder& occluder, std::size_t first, std::size_t second) const;
  void find_occluders();
  void find_solids();
  void find_neighbours();
  void find_contained();

  Scene scene_;
  Rational unit_;
  MeshTopology topology_;
  std::vector<double> areas_;
  std::vector<Vector<double>> unit_normals_;
  double total_area_ = 0;
  std::vector<ConvexOccluder> occluders_;
  std::vector<std::size_t> occluder_triangle_;  ///< a triangle of each
  std::vector<bool> is_body_;
  std::vector<std::vector<std::size_t>> bodies_of_;  ///< for each triangle the bodies that it lies within
  BoxTree tree_;                                     ///< of the occluders' boxes
};

}  // namespace radcert
