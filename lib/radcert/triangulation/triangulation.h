// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/surface/surface.h"

namespace radcert {

/// A triangle of a chart's parameter plane, the hat Delta_k of the papers.
/// Maths     vertices v_1, v_2, v_3; Delta_k = F_j(hat Delta_k), m_k = F_j(x_1 v_1 + x_2 v_2 + x_3 v_3)
/// Source    [ac98, (27)-(29)], numbered as in [m06, (12)]
/// Requires  not degenerate, counter-clockwise
/// Result    vertices are exact: dyadic numbers unless the triangulation is graded
struct ParameterTriangle {
  std::size_t chart = 0;
  std::array<ParameterPoint<double>, 3> vertices;

  /// The point with barycentric coordinates x.
  ParameterPoint<double> at(const std::array<double, 3>& x) const {
    return x[0] * vertices[0] + x[1] * vertices[1] + x[2] * vertices[2];
  }
  /// Twice the area, to a rounding of its own size, however thin the triangle is.
  [[nodiscard]] double doubled_area() const;
};

/// How the coarse triangulation is cut and the refined one graded.
struct TriangulationOptions {
  /// That triangulates every chart, chart by chart in their order; null: by the diagonals.
  std::shared_ptr<const std::vector<ParameterTriangle>> coarse = nullptr;
  std::optional<std::vector<Diagonal>> diagonals;  ///< by chart; absent: those of the surface
  double grading =
      1;  ///< >= 1: coordinates of unit squares moved towards both ends, c -> (2c)^grading / 2 for c <= 1/2
};

/// A triangulation of a surface's parameter domains.
/// Maths     level 0 is `coarse`, or cuts each unit square along a diagonal and takes unit triangles as they
///           are; each level divides every triangle into four by midpoints of sides (symmetric refinement)
/// Source    [ac98, section 3.2, before Theorem 3.7]; the diagonals: recovered from the printed tables
/// Requires  0 <= level, grading >= 1, a coarse triangulation without grading; triangle_count(surface, level,
///           options) fits, else ContractViolation
/// Result    triangles chart by chart; the four children of a triangle follow each other: those at v_1, v_2,
///           v_3, the middle
/// Limits    conforming within each chart and, for the catalogue's surfaces, across their seams; a graded one
///           not across those between unit squares and unit triangles, which are not graded: the mantle and
///           the disks of a cylinder
struct Triangulation {
  std::vector<ParameterTriangle> triangles;
};

/// The triangulation of a surface at a level. Requires and result as Triangulation.
Triangulation triangulate(const Surface& surface, int level, const TriangulationOptions& options = {});

/// Triangles that follow each other.
struct ElementRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A part of the triangulation of a level.
/// Requires  as triangulate; grading 1; a range within the level's triangles, else ContractViolation
/// Result    these triangles of triangulate, to the bit; the others are not made
[[nodiscard]] Triangulation triangulate_part(const Surface& surface, int level,
                                             const TriangulationOptions& options, const ElementRange& part);

/// A child of a triangle in symmetric refinement: those at v_1, v_2, v_3, the middle.
/// Requires  c < 4
/// Result    exact while the vertices are multiples of 2^-51 in the unit square
[[nodiscard]] ParameterTriangle child_of(const ParameterTriangle& triangle, std::size_t c);

/// One of the 4^levels triangles into which a triangle is refined so often, in the order of Triangulation.
/// Result    as if refined level by level, to the bit
[[nodiscard]] ParameterTriangle descendant_of(const ParameterTriangle& triangle, int levels,
                                              std::size_t number);

/// The number of triangles of a level, or nothing if it exceeds 2^53.
std::optional<std::uint64_t> triangle_count(const Surface& surface, int level,
                                            const TriangulationOptions& options = {});

/// The largest diameter of the triangles in the parameter plane.
/// Maths     h = max_k diameter(hat Delta_k)
/// Source    [ac98, section 3], [m06, (11)]
/// Requires  a triangulation that is not empty
/// Result    in the unit of the parameters, rounded
/// Limits    says nothing of lengths on S
double mesh_size(const Triangulation& triangulation);

}  // namespace radcert
