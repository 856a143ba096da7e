// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The facts of a mesh as a surface.
struct MeshFacts {
  Orientation orientation = Orientation::against_the_cross_product;  ///< where inner normals point
  bool closed = false;
  bool unoccluded = false;
};

/// A mesh as a surface: every triangle an affine chart.
/// Maths     F(s,t) = v_1 + s (v_2 - v_1) + t (v_3 - v_1) on the unit triangle
/// Source    [ac98, (13)]: smooth pieces, and [m06, (9)]: triangles
/// Requires  no degenerate triangle; piece_of_triangle numbers the pieces from 0 in the order in which
///           triangles first show them
/// Result    charts in the order of the triangles, named piece/number; each knows its exact plane, so that G
///           = 0 between coplanar triangles is decided exactly. charts_join_smoothly where each piece is
///           plane; pieces_meet_at_angle where a vertex has triangles in different planes
/// Limits    a piece that stands for something round stays what the mesh is, a polyhedron
[[nodiscard]] Surface mesh_surface(const std::string& name, const TriangleMesh& mesh,
                                   std::span<const std::size_t> piece_of_triangle,
                                   std::span<const std::string> piece_names, const MeshFacts& facts);

}  // namespace radcert
