// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"

namespace radcert::verification::ac98 {

/// A convex polyhedron with rational corners.
/// Maths     faces with normals into the body
/// Result    exact
struct Polyhedron {
  std::string name;
  std::vector<Vector<Rational>> corners;
  std::vector<PlanePolygon> faces;
};
[[nodiscard]] Polyhedron cube_polyhedron();  ///< [0,1]^3
/// [0,a] x [0,b] x [0,c].
[[nodiscard]] Polyhedron box_polyhedron(const Rational& a, const Rational& b, const Rational& c);
[[nodiscard]] Polyhedron tetrahedron();  ///< every other corner of [-1,1]^3
[[nodiscard]] Polyhedron octahedron();   ///< +- the unit vectors
/// The face z = 0 of the cube.
inline constexpr std::size_t floor_face = 0;

/// Pairs of a face and a corner for which the corner lies behind the plane of the face: none if and only if
/// the polyhedron is convex and all normals point inwards, and then both cosines of (2), and G, are >= 0 for
/// every pair of its points.
[[nodiscard]] Rational corners_behind_faces(const Polyhedron& polyhedron);

/// Int_S G from a point of a face, off its edges, to all other faces.
/// Maths     sum of point_to_polygon_within
/// Source    [ac98, (7)]
/// Requires  P in the face
/// Result    enclosed to within `radius`
[[nodiscard]] Ball total_factor(const Polyhedron& polyhedron, std::size_t face, const Vector<Rational>& p,
                                const Rational& radius);

/// Random rational points inside a face; every third one within 1e-6 of a side.
[[nodiscard]] std::vector<Vector<Rational>> random_face_points(const PlanePolygon& face, std::size_t count,
                                                               std::uint64_t seed);

}  // namespace radcert::verification::ac98
