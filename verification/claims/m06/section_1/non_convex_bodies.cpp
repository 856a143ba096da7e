// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/section_1/non_convex_bodies.h"

#include <algorithm>

namespace radcert::verification::m06 {
namespace {

using Point = Vector<Rational>;

/// The faces run counterclockwise as seen from outside; turned over, their normals point inwards.
NonConvexBody body_of(std::string name, const std::vector<Point>& corners,
                      const std::vector<std::vector<std::size_t>>& faces) {
  NonConvexBody body{.name = std::move(name), .faces = {}};
  for (const std::vector<std::size_t>& face : faces) {
    std::vector<Point> points;
    for (const std::size_t i : face) points.push_back(corners.at(i));
    std::reverse(points.begin(), points.end());
    body.faces.push_back(plane_polygon(points).value());
  }
  return body;
}

}  // namespace

NonConvexBody l_shaped_room() {
  std::vector<Point> corners;
  for (const int z : {0, 1})
    for (const auto& [x, y] :
         std::vector<std::pair<int, int>>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
      corners.push_back({x, y, z});
  std::vector<std::vector<std::size_t>> faces{{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  constexpr std::size_t sides = 6;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t next = (i + 1) % sides;
    faces.push_back({i, next, sides + next, sides + i});
  }
  return body_of("L-shaped room", corners, faces);
}

NonConvexBody dented_octahedron() {
  return body_of("dented octahedron",
                 {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, Rational(-1, 4)}, {0, 0, -1}},
                 {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

Ball signed_total(const NonConvexBody& body, std::size_t face, const Point& p, BehindTangentPlane behind,
                  const Rational& radius) {
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  const Rational share = radius / Rational(body.faces.size());
  Ball sum;
  for (std::size_t k = 0; k < body.faces.size(); ++k) {
    if (k == face) continue;
    const Outcome<Ball> part =
        point_to_polygon_within(share, p, body.faces.at(face).normal(), body.faces[k], one, behind);
    sum += part ? *part : Ball::failed("a part was not enclosed");
  }
  return sum;
}

Point point_of_face(const NonConvexBody& body, std::size_t face, std::size_t corner) {
  const PlanePolygon& polygon = body.faces.at(face);
  const PolygonLoop& loop = polygon.loops().front();
  const auto at = [&](std::size_t i) { return polygon.point(loop[(corner + i) % loop.size()]); };
  return Rational(1, 7) * (Rational(3) * at(0) + Rational(2) * at(1) + Rational(2) * at(2));
}

}  // namespace radcert::verification::m06
