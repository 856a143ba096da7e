// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radcert/factors/factor_matrix.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// Plane triangles that light meets, with names.
/// Maths     (v_2 - v_1) x (v_3 - v_1) points to where light travels
/// Result    piece numbers piece_names; the mesh has its groups
struct FactorMesh {
  TriangleMesh mesh;
  std::vector<std::size_t> piece;
  std::vector<std::string> piece_names;
  /// Whether a piece has triangles of several planes: then the mesh may stand for something round.
  bool pieces_bend = false;
  /// The length that the coordinates of the mesh count: those of a surface whose sides are thirds may be
  /// whole.
  Rational unit = 1;
  /// Whether the corners, times the unit, are those of what is named, and none was rounded.
  bool exact = true;
};

/// A surface of the catalogue, each triangle cut into 4^level.
/// Maths     the triangulation of that level; corners F(s,t). Where these have denominators other than
///           powers of 2, of which the least common multiple is n, they are counted in units of 2^k / n, 1 <=
///           n / 2^k < 2: then numerators of few digits are doubles
/// Source    triangulate; the exact formulas of the charts, affine_image
/// Requires  plane charts, else ContractViolation; 0 <= level
/// Result    exact corners with the unit 1, where all of them are doubles; else in the unit above, where they
///           are doubles in it; else with the unit 1, each coordinate rounded to nearest, and !exact
/// Limits    charts without an exact formula, not those of the catalogue, count as rounded, and come apart
///           where their common corners round differently
[[nodiscard]] FactorMesh factor_mesh(const Surface& surface, int level);

/// A mesh file, turned so that its inner normals are those of the cross product.
/// Requires components, else ContractViolation.
[[nodiscard]] FactorMesh factor_mesh(const MeshSurvey& survey);

/// The part of the scene that one row and one column of a matrix stand for.
enum class FactorUnit { triangle, piece, group };

/// Triangles "piece/1", "piece/2", ..., pieces by their names, or groups; a group without a name is
/// "ungrouped".
[[nodiscard]] FactorUnits factor_units(const FactorMesh& mesh, FactorUnit unit);

}  // namespace radcert
