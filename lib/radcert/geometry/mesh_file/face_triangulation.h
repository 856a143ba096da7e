// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// What becomes of faces whose corners do not lie in one plane: there the diagonals decide what the surface
/// is.
enum class BentFaces {
  refused,  ///< an InputError that names the first
  cut,      ///< they are cut as plane faces are, and the diagonals told
};

/// A mesh of triangles, and how it came from faces of more corners.
/// Maths     a face of k corners becomes k - 2 triangles with its corners as vertices. A face is bent unless
///           all of its corners lie in the plane through three of them that are not on one line
/// Source    polygon_triangles in the coordinate plane in which the face is largest, or in the next where
///           that fails: the diagonals make the least angles there as large as they can be; every decision
///           exact
/// Result    triangles in the order of the faces, oriented as they are. cut_faces: how many had more than 3
///           corners; bent_faces: those of them that are bent, by one unit in the last place of a coordinate
///           too; diagonals: of each bent face, at most of the first hundred, how far it is bent and which
///           diagonals were taken. The distance is that of the corner farthest from the plane through the
///           mean of the corners with the sum of their cross products as normal: exact, rounded up
/// Limits    a face that is simple in none of these planes is an InputError that names it
struct TriangulatedFaces {
  TriangleMesh mesh;
  std::size_t cut_faces = 0;
  std::vector<std::size_t> bent_faces;
  std::vector<std::string> diagonals;
};

/// The faces of a file as triangles.
/// Result    as TriangulatedFaces; InputError that names the first bent face where these are refused
[[nodiscard]] TriangulatedFaces triangulate_faces(const MeshFile& file, BentFaces bent = BentFaces::refused);

}  // namespace radcert
