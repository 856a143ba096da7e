// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/geometry/vector.h"

namespace radcert {

/// How finely a file gives its coordinates.
/// Maths     a coordinate stands for any number within `unit` of it
/// Source    half a unit in the last place of a 32-bit float or a double, or of the last printed digit; of
///           the largest coordinate
/// Result    for text the number of digits is that of the coordinate printed with the most: %g drops zeros at
///           the end
/// Limits    a guess, but for `rounding`, at what the author rounded, for judging how large a defect is; no
///           decision depends on it
struct CoordinatePrecision {
  double unit = 0;
  std::string words;  ///< "printed with 6 digits", "32-bit floats"
  /// Bounds the distance of a decimal in the file from the double that it was read as; 0 where all are
  /// doubles
  double rounding = 0;
};

/// Faces of any number of corners, as a mesh file has them.
/// Maths     face k has the corners corner[face_begin[k]], ..., corner[face_begin[k+1] - 1]
/// Result    as in the file; the corners of STL, VTU and glTF joined where they are equal. Every
///           index is below vertices.size(), and a face has at least three different corners, none twice
/// Limits    texture, colours and normals are left out
struct MeshFile {
  std::string format;  ///< "OFF", "OBJ", "PLY, ASCII", "PLY, binary", "STL, ASCII", "MSH 4.1", ...
  std::vector<Vector<double>> vertices;
  std::vector<std::size_t> corner;
  std::vector<std::size_t> face_begin{0};
  std::vector<std::uint64_t> face_place;  ///< of each face, where it ends in the file
  std::string unit_of_place;              ///< what these count: "line", "byte", "cell" or "triangle"
  std::vector<std::size_t> group;
  std::vector<std::string> group_names;
  std::size_t joined_corners = 0;  ///< of STL, VTU, glTF: how many corners were found to be one of others
  CoordinatePrecision precision;
  std::string digest;  ///< of the file's bytes

  [[nodiscard]] std::size_t face_count() const { return face_begin.size() - 1; }
  /// "face 7 (line 31)": counted from 1.
  [[nodiscard]] std::string face_text(std::size_t face) const;
};

/// A mesh from a file.
/// Source    the formats OFF (Geomview), OBJ (Wavefront), PLY (Stanford), STL (3D Systems), MSH (Gmsh), VTK
///           (legacy) and VTU, VS3 (View3D) and glTF 2.0 (Khronos); own readers: those of CGAL give no line
///           of what is wrong, no group, no number of printed digits
/// Requires  a name that ends in one of mesh_file_endings()
/// Result    OBJ: groups from o, g and usemtl, joined by "/"; STL: from solid; MSH: the physical groups of
///           surfaces; VS3: the names of surfaces, what is combined with another having its name; VTU: the
///           cell data piece, group, gmsh:physical or CellEntityIds, with the names of a legend "piece 3:
///           floor"; glTF: the names of nodes, else of meshes, and of materials, joined by "/". InputError
///           with the file, the line or byte, the value and what is allowed: for words that are no decimal
///           number, numbers that are not finite, beyond 1e60 or so small that a double holds 0 in their
///           place, lines with more or fewer numbers than their kind has, for faces with a corner that is
///           missing, repeated or not there, for a file without faces, a text that is no STL, a file that
///           ends too early or goes on too long
/// Limits    files up to 4 GiB; OFF and OBJ as text, a vertex or a face a line; MSH of the versions 2.2 and
///           4.1 and legacy VTK as text, VTU as text or binary, compressed by zlib or not, with triangles,
///           quadrangles and polygons of first order; of VS3 neither surfaces within a base nor obstructions;
///           glTF with its buffers inside, single precision, neither compressed nor sparse
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& path);

/// The same from the bytes of a file; `name` stands in messages, and its ending names the format.
[[nodiscard]] MeshFile parse_mesh_file(std::string_view bytes, const std::string& name);

/// Whether a name ends like that of a mesh file.
[[nodiscard]] bool is_mesh_file_name(const std::string& name);

/// ".off, .obj, ...".
[[nodiscard]] std::string mesh_file_endings();

}  // namespace radcert
