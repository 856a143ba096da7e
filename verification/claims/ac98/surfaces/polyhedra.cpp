// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/polyhedra.h"

#include <algorithm>
#include <random>

namespace radcert::verification::ac98 {
namespace {

using Point = Vector<Rational>;

// A face whose corners are in order of either sense, turned so that its normal points to the inner point.
PlanePolygon face_towards(const Point& inside, std::vector<Point> corners) {
  const PlanePolygon face = plane_polygon(corners).value();
  if (dot(inside - face.origin(), face.normal()).sign() > 0) return face;
  std::reverse(corners.begin(), corners.end());
  return plane_polygon(corners).value();
}

Polyhedron polyhedron(std::string name, std::vector<Point> corners, const Point& inside,
                      const std::vector<std::vector<std::size_t>>& faces) {
  Polyhedron result{.name = std::move(name), .corners = std::move(corners), .faces = {}};
  for (const std::vector<std::size_t>& face : faces) {
    std::vector<Point> points;
    for (const std::size_t i : face) points.push_back(result.corners.at(i));
    result.faces.push_back(face_towards(inside, std::move(points)));
  }
  return result;
}

}  // namespace

Polyhedron cube_polyhedron() {
  Polyhedron cube = box_polyhedron(1, 1, 1);
  cube.name = "cube";
  return cube;
}

Polyhedron box_polyhedron(const Rational& a, const Rational& b, const Rational& c) {
  return polyhedron("box (" + a.to_text() + "," + b.to_text() + "," + c.to_text() + ")",
                    {{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}},
                    {a / 2, b / 2, c / 2},
                    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

Polyhedron tetrahedron() {
  return polyhedron("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {0, 0, 0},
                    {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
}

Polyhedron octahedron() {
  return polyhedron("octahedron", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                    {0, 0, 0},
                    {{0, 1, 2}, {3, 1, 2}, {0, 4, 2}, {3, 4, 2}, {0, 1, 5}, {3, 1, 5}, {0, 4, 5}, {3, 4, 5}});
}

Rational corners_behind_faces(const Polyhedron& polyhedron) {
  long count = 0;
  for (const PlanePolygon& face : polyhedron.faces)
    for (const Point& corner : polyhedron.corners)
      if (dot(corner - face.origin(), face.normal()).sign() < 0) ++count;
  return {count};
}

Ball total_factor(const Polyhedron& polyhedron, std::size_t face, const Point& p, const Rational& radius) {
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  const Rational share = radius / Rational(polyhedron.faces.size());
  Ball sum;
  for (std::size_t k = 0; k < polyhedron.faces.size(); ++k) {
    if (k == face) continue;
    const Outcome<Ball> part =
        point_to_polygon_within(share, p, polyhedron.faces.at(face).normal(), polyhedron.faces[k], one);
    sum += part ? *part : Ball::failed("a part was not enclosed");
  }
  return sum;
}

std::vector<Point> random_face_points(const PlanePolygon& face, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  const PolygonLoop& loop = face.loops().front();
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    // Weights of the corners; every third point has but a millionth for all corners except two neighbours.
    std::vector<Rational> weights;
    Rational sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Rational weight(static_cast<long>(bits() % 1000) + 1);
      if (i % 3 == 2 && k >= 2) weight /= 1000000;
      sum += weight;
      weights.push_back(weight);
    }
    ParameterPoint<Rational> at{0, 0};
    for (std::size_t k = 0; k < loop.size(); ++k) at = at + (weights[k] / sum) * loop[k];
    points.push_back(face.point(at));
  }
  return points;
}

}  // namespace radcert::verification::ac98
