// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"

namespace radcert::verification::m06 {

/// A polyhedron that is not convex, with rational corners.
/// Maths     faces with normals into the body
/// Result    exact
struct NonConvexBody {
  std::string name;
  std::vector<PlanePolygon> faces;
};
[[nodiscard]] NonConvexBody l_shaped_room();      ///< a hexagon with one corner bent in, one unit high
[[nodiscard]] NonConvexBody dented_octahedron();  ///< its upper vertex at the height -1/4

/// Int_S G(P,Q) dS_Q from a point of a face, V left out.
/// Maths     the sum of point_to_polygon_within over all faces
/// Source    [m06, Lemma 1 (c)]
/// Requires  P inside the face
/// Result    enclosed to within `radius`
[[nodiscard]] Ball signed_total(const NonConvexBody& body, std::size_t face, const Vector<Rational>& p,
                                BehindTangentPlane behind, const Rational& radius);

/// The mean of three corners of a face, with weights that differ.
/// Maths     (3 a + 2 b + 2 c) / 7, a the corner with the given number, b and c those after it
/// Requires  a face and a corner of the body
/// Result    exact; inside the face where it is convex at b
[[nodiscard]] Vector<Rational> point_of_face(const NonConvexBody& body, std::size_t face, std::size_t corner);

}  // namespace radcert::verification::m06
