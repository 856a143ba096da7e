// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// An edge of a mesh and the sides of triangles along it.
struct MeshEdge {
  std::size_t from;   ///< the smaller of its two vertices
  std::size_t to;     ///< the larger
  std::size_t begin;  ///< its sides are MeshTopology::sides[begin], ..., sides[end - 1]
  std::size_t end;
  [[nodiscard]] std::size_t side_count() const { return end - begin; }
};

/// Side i of a triangle, from its vertex i to its vertex i + 1 (mod 3).
struct TriangleSide {
  std::size_t triangle;
  std::size_t side;
  bool forward;  ///< it runs from MeshEdge::from to MeshEdge::to
};

/// How the triangles of a mesh fit together.
/// Maths     two triangles are neighbours across an edge that is a side of exactly these two. characteristic
///           = V - E + F over the vertices that triangles use; turned: the least set of triangles, component
///           by component, whose reversal makes neighbours agree
/// Requires  triangles whose vertices differ; others are left out
/// Result    edges in the order of their vertices; everything by the vertices' numbers alone, exact.
///           component[t] numbers the sets that are connected through neighbours. crooked_edge: an edge that
///           shows that no reversal makes neighbours agree
/// Limits    vertices with equal coordinates and different numbers are different vertices
struct MeshTopology {
  std::vector<MeshEdge> edges;
  std::vector<TriangleSide> sides;
  std::vector<std::array<std::size_t, 3>> edge_of_side;  ///< of each triangle; no_edge where it was left out
  std::size_t used_vertices = 0;
  std::ptrdiff_t characteristic = 0;
  std::vector<std::size_t> component;
  std::size_t component_count = 0;
  std::vector<std::size_t> open_edges;         ///< with one side
  std::vector<std::size_t> crowded_edges;      ///< with three sides or more
  std::vector<std::size_t> disagreeing_edges;  ///< with two sides that run the same way
  /// Whose triangles are not connected through neighbours around it
  std::vector<std::size_t> pinched_vertices;
  /// The open edges as lines of vertices, closed ones without repetition.
  std::vector<std::vector<std::size_t>> open_loops;
  std::vector<std::size_t> turned;  ///< triangles that disagree with the majority of their component
  std::optional<std::size_t> crooked_edge;

  static constexpr std::size_t no_edge = static_cast<std::size_t>(-1);
  [[nodiscard]] bool closed() const { return open_edges.empty() && crowded_edges.empty(); }
  [[nodiscard]] bool orientable() const { return !crooked_edge.has_value(); }
};

/// How the triangles of a mesh hang together. Requires and result as MeshTopology.
[[nodiscard]] MeshTopology mesh_topology(const TriangleMesh& mesh);

/// The sign of the volume within a closed mesh: 1 where its triangles run counterclockwise as seen from
/// outside.
/// Maths     sign of sum over the triangles of det(v_1, v_2, v_3)
/// Source    the divergence theorem
/// Requires  a closed mesh whose triangles agree
/// Result    -1, 0 or 1, exact
/// Limits    of several components the sum: see mesh_topology
[[nodiscard]] int volume_sign(const TriangleMesh& mesh);

}  // namespace radcert
