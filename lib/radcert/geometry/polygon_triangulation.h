// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "radcert/geometry/plane_polygon.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// Triangles of a parameter plane, exactly.
struct PlaneTriangulation {
  std::vector<ParameterPoint<Rational>> vertices;
  std::vector<VertexTriple> triangles;  ///< counterclockwise
};

/// A side of a polygon: from vertex `side` of loop `loop` to the next.
struct PolygonSide {
  std::size_t loop = 0;
  std::size_t side = 0;
};

/// The triangulation of a polygon, with holes or without, by its own vertices.
/// Maths     constrained Delaunay: of the triangulations that contain all sides the one whose least angles
///           are largest
/// Source    CGAL, exact arithmetic
/// Result    conforming, as [m06, T1-T3] ask, and exact; the vertices are those of the loops, in their order
/// Limits    as sharp as the polygon makes it: no vertex is added
[[nodiscard]] PlaneTriangulation triangulate(const PlanePolygon& polygon);

/// The same for one loop of doubles.
/// Maths     constrained Delaunay, as above
/// Source    CGAL, exact predicates
/// Requires  finite coordinates
/// Result    places of the corners; the triangles run the way round that the loop does. Nothing where sides
///           meet but neighbours at their corner, or where fewer than three corners are given
[[nodiscard]] std::optional<std::vector<VertexTriple>> polygon_triangles(
    std::span<const ParameterPoint<double>> corners);

/// The same for one loop of points of space.
/// Maths     in the coordinate plane in which it is largest, or in another where rounding misled about that:
///           in its own plane a polygon is simple if its image is
/// Requires  finite coordinates, three corners or more
/// Result    as above; nothing where no image is simple
[[nodiscard]] std::optional<std::vector<VertexTriple>> polygon_triangles(
    std::span<const Vector<double>> corners);

/// The same triangulation, finer toward chosen sides.
/// Maths     `times` times every triangle with a vertex on a chosen side is bisected; a triangle is bisected
///           at its longest side, and with it the neighbour there, after that was bisected until the side is
///           its longest as well
/// Source    Rivara: longest-side bisection
/// Requires  a conforming triangulation of the polygon; sides that are there, times >= 0, else
///           ContractViolation
/// Result    conforming and exact: new vertices are the midpoints of sides, as rational numbers
/// Limits    digits grow by a bit a bisection
[[nodiscard]] PlaneTriangulation graded_toward(PlaneTriangulation triangulation, const PlanePolygon& polygon,
                                               std::span<const PolygonSide> sides, int times);

}  // namespace radcert
