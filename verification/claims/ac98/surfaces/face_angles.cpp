// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/face_angles.h"

#include <utility>
#include <vector>

namespace radcert::verification::ac98 {
namespace {

using Point = Vector<Rational>;

std::vector<Point> corners_of(const PlanePolygon& face, const PolygonLoop& loop) {
  std::vector<Point> corners;
  for (const ParameterPoint<Rational>& at : loop) corners.push_back(face.point(at));
  return corners;
}

Rational corners_without_a_left_turn(const Polyhedron& polyhedron) {
  long count = 0;
  for (const PlanePolygon& face : polyhedron.faces) {
    const std::vector<Point> at = corners_of(face, face.loops().front());
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Point& middle = at[(i + 1) % at.size()];
      const Point turn = cross(middle - at[i], at[(i + 2) % at.size()] - middle);
      if (dot(turn, face.normal()).sign() <= 0) ++count;
    }
  }
  return {count};
}

}  // namespace

Rational sides_without_opposite(const Polyhedron& polyhedron) {
  std::vector<std::pair<Point, Point>> sides;
  for (const PlanePolygon& face : polyhedron.faces)
    for (const PolygonLoop& loop : face.loops()) {
      const std::vector<Point> at = corners_of(face, loop);
      for (std::size_t i = 0; i < at.size(); ++i) sides.emplace_back(at[i], at[(i + 1) % at.size()]);
    }
  long count = 0;
  for (const auto& [a, b] : sides) {
    long opposite = 0;
    for (const auto& [from, to] : sides)
      if (from == b && to == a) ++opposite;
    if (opposite != 1) ++count;
  }
  return {count};
}

void require_total_of_pi(Finding& finding, const Polyhedron& polyhedron) {
  finding.require("corners behind a face, " + polyhedron.name, IsExactly{0},
                  corners_behind_faces(polyhedron));
  finding.require("sides of faces without the opposite side, " + polyhedron.name, IsExactly{0},
                  sides_without_opposite(polyhedron));
  finding.require("corners where a face does not turn to the left, " + polyhedron.name, IsExactly{0},
                  corners_without_a_left_turn(polyhedron));
  Polyhedron open = polyhedron;
  open.faces.pop_back();
  finding.control("sides of faces without the opposite side, " + polyhedron.name + " without a face",
                  IsExactly{0}, sides_without_opposite(open));
}

}  // namespace radcert::verification::ac98
