// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/mesh_file.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// A mesh of triangles, and how it came from faces of more corners.
/// Maths     a face of k corners becomes k - 2 triangles with its corners as vertices
/// Source    ears, cut off in the coordinate plane in which the face is largest; every decision exact
/// Requires  -
/// Result    triangles in the order of the faces, oriented as they are. cut_faces: how many had more than 3 corners; bent_faces: those
///           of them whose corners do not lie in one plane exactly: there the diagonals decide what the surface is
/// Limits    a face that is not simple in that plane, or has more than 10000 corners, is an InputError that names it
struct TriangulatedFaces {
  TriangleMesh mesh;
  std::size_t cut_faces = 0;
  std::vector<std::size_t> bent_faces;
};

[[nodiscard]] TriangulatedFaces triangulate_faces(const MeshFile& file);

}  // namespace radcert
