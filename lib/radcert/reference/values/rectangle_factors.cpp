// SPDX-License-Identifier: GPL-3.0-or-later

// Configuration factors of plane rectangles and triangles: the formula of the catalogue, and the contour
// integral over polygons, whose edges meet by pairs in Clausen's integral.
#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/reference/values/families.h"

namespace radcert::reference::values {
namespace {

using Point = Vector<Rational>;

PlanePolygon polygon(const std::vector<Point>& corners) { return plane_polygon(corners).value(); }

Route by_contours(std::function<std::pair<PlanePolygon, PlanePolygon>(const Arguments&)> pair) {
  Route route;
  route.how = "contour integral over two polygons, edge pairs by Clausen's integral";
  route.enclose = [pair = std::move(pair)](const Arguments& arguments, const Rational& radius) {
    const auto [from, to] = pair(arguments);
    return polygon_to_polygon_within(from, to, radius);
  };
  return route;
}

std::pair<PlanePolygon, PlanePolygon> opposed(const Arguments& a) {
  const Rational &w = a[0], &d = a[1], &h = a[2];
  return {polygon({{0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0}}),
          polygon({{0, 0, h}, {0, d, h}, {w, d, h}, {w, 0, h}})};
}

/// The common edge lies on the x-axis; the first rectangle in z = 0, the second in y = 0.
std::pair<PlanePolygon, PlanePolygon> perpendicular(const Arguments& a) {
  const Rational &edge = a[0], &from = a[1], &to = a[2];
  return {polygon({{0, 0, 0}, {edge, 0, 0}, {edge, from, 0}, {0, from, 0}}),
          polygon({{0, 0, 0}, {0, 0, to}, {edge, 0, to}, {edge, 0, 0}})};
}

/// Four corners of a cube that form a regular tetrahedron; faces seen from inside.
std::pair<PlanePolygon, PlanePolygon> regular_faces(const Arguments&) {
  const Point a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
  return {polygon({a, c, b}), polygon({a, b, d})};
}

/// Two legs of the tetrahedron 0, e_1, e_2, e_3.
std::pair<PlanePolygon, PlanePolygon> corner_legs(const Arguments&) {
  const Point o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  return {polygon({o, x, y}), polygon({o, y, z})};
}

}  // namespace

Theme rectangle_factors() {
  Theme theme;
  theme.families = {
      {.name = "opposed_rectangles",
       .summary = "configuration factor between two equal rectangles, directly opposed",
       .formula = "1/(pi A) Int Int cos cos / r^2",
       .source = "Howell C-11",
       .parameters = {positive("width", "1"), positive("depth", "1"), positive("distance", "1")},
       .route = by_formula("closed form, Howell C-11",
                           [](const Arguments& a) { return opposed_rectangles(a[0], a[1], a[2]); }),
       .second_route = by_contours(opposed)},
      {.name = "perpendicular_rectangles",
       .summary = "configuration factor between two rectangles at a right angle with an edge in common",
       .formula = "1/(pi A) Int Int cos cos / r^2",
       .source = "Howell C-14",
       .parameters = {positive("edge", "1"), positive("from_width", "1"), positive("to_width", "1")},
       .route = by_formula("closed form, Howell C-14",
                           [](const Arguments& a) { return perpendicular_rectangles(a[0], a[1], a[2]); }),
       .second_route = by_contours(perpendicular)},
      {.name = "regular_tetrahedron_faces",
       .summary = "configuration factor between two faces of a regular tetrahedron",
       .formula = "1/3",
       .source = "symmetry and closure",
       .parameters = {},
       .route = by_formula("symmetry and closure", [](const Arguments&) { return regular_tetrahedron(); }),
       .second_route = by_contours(regular_faces)},
      {.name = "corner_tetrahedron_legs",
       .summary = "configuration factor between two legs of the tetrahedron 0, e_1, e_2, e_3",
       .formula = "(3 - sqrt(3))/6",
       .source = "symmetry, closure and reciprocity",
       .parameters = {},
       .route = by_formula("symmetry, closure and reciprocity",
                           [](const Arguments&) { return corner_tetrahedron(); }),
       .second_route = by_contours(corner_legs)},
  };
  theme.named = {
      {"cube_opposite_faces", "opposed_rectangles", {1, 1, 1}},
      {"parallel_squares_h_1/2", "opposed_rectangles", {1, 1, Rational(1, 2)}},
      {"parallel_squares_h_2", "opposed_rectangles", {1, 1, 2}},
      {"parallel_squares_h_1/10", "opposed_rectangles", {1, 1, Rational(1, 10)}},
      {"parallel_squares_h_10", "opposed_rectangles", {1, 1, 10}},
      {"parallel_rectangles_1_2_3", "opposed_rectangles", {1, 2, 3}},
      {"cube_adjacent_faces", "perpendicular_rectangles", {1, 1, 1}},
      {"box_1_2_3_floor_to_long_wall", "perpendicular_rectangles", {2, 1, 3}},
      {"box_1_2_3_floor_to_short_wall", "perpendicular_rectangles", {1, 2, 3}},
      {"perpendicular_strip_on_square", "perpendicular_rectangles", {1, 1, Rational(1, 10)}},
      {"regular_tetrahedron_adjacent", "regular_tetrahedron_faces", {}},
      {"corner_tetrahedron_leg_to_leg", "corner_tetrahedron_legs", {}},
  };
  return theme;
}

}  // namespace radcert::reference::values
