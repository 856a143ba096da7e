// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// The faults for which a mesh is refused as a scene.
enum class SceneFaultKind {
  not_finite,   ///< a coordinate is not finite or beyond Scene::largest_coordinate
  degenerate,   ///< a triangle's corners lie on one line
  doubled,      ///< two triangles have the same corners: a body without thickness, or one face given twice
  overlapping,  ///< two triangles of one plane have more in common than a side or a vertex
  crossing,     ///< two triangles of different planes have, touching in an interior included
};

/// One fault, in words with numbers and coordinates.
struct SceneFault {
  SceneFaultKind kind;
  std::size_t first;   ///< a triangle
  std::size_t second;  ///< the other; `first` again where there is none
  std::string words;
};

/// The faults of a mesh as a scene.
/// Maths     two triangles of a scene have nothing in common, a vertex or a side
/// Source    mesh_defects
/// Requires  vertices that are there, else ContractViolation
/// Result    exact for the given doubles, in the order of the kinds, then of the triangles; empty: Scene
///           holds its promises. At most most_crossings pairs
/// Limits    says nothing of holes or of the orientation: see mesh_topology
[[nodiscard]] std::vector<SceneFault> scene_faults(const TriangleMesh& mesh);

/// Plane triangles that light meets: a mesh made ready for exact questions of visibility.
/// Maths     a triangle looks to the side that (v_2 - v_1) x (v_3 - v_1) points to, which is the inside of an
///           enclosure; it is seen from that side alone, and hides from both sides
/// Source    [ac98, section 1]
/// Requires  no degenerate triangle, coordinates of at most largest_coordinate, else ContractViolation
/// Result    immutable, shared by threads. Vertices with equal coordinates are one. plane(t) numbers the
///           planes as sets: two triangles with one number lie in one plane, whichever way they look; exact
/// Limits    where scene_faults(mesh) is not empty, visible parts are wrong near crossing triangles; touching
///           and overlapping ones do no harm
class Scene {
public:
  /// 2^100: products of six differences neither overflow nor fall below what an error bound allows for.
  static constexpr double largest_coordinate = 0x1p100;

  explicit Scene(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }
  [[nodiscard]] std::array<Vector<double>, 3> corners(std::size_t triangle) const {
    return mesh_.corners(triangle);
  }
  /// The numbers of the corners, equal ones for equal coordinates.
  [[nodiscard]] const VertexTriple& vertices(std::size_t triangle) const { return vertices_[triangle]; }
  [[nodiscard]] const Vector<double>& vertex(std::size_t number) const { return mesh_.vertices[number]; }
  [[nodiscard]] std::size_t plane(std::size_t triangle) const { return plane_[triangle]; }
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  /// The largest e for which all coordinates are multiples of 2^e.
  [[nodiscard]] int lowest_exponent() const { return lowest_exponent_; }

private:
  TriangleMesh mesh_;
  std::vector<VertexTriple> vertices_;
  std::vector<std::size_t> plane_;
  BoxTree tree_;
  int lowest_exponent_;
};

}  // namespace radcert
