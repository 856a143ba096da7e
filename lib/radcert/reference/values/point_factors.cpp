// SPDX-License-Identifier: GPL-3.0-or-later

// Factors from a point to a plane polygon, with 1/pi: Lambert's formula and its extension to polynomial
// densities, and the double integral of the kernel by enclosed Gauss rules.
#include <algorithm>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/reference/values/families.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert::reference::values {
namespace {

/// Beyond so many digits the double integral takes long.
constexpr int digits_of_a_double_integral = 40;

/// A point with its normal, a part of the parallelogram origin + s first + t second, and c_0 + c_1 s + c_2 t
/// on it.
struct Configuration {
  Vector<Rational> point;
  Vector<Rational> normal;
  Vector<Rational> origin;
  Vector<Rational> first;
  Vector<Rational> second;
  PolygonLoop part;
  std::array<Rational, 3> density;
};

Route by_lambert(std::function<Configuration(const Arguments&)> configuration) {
  Route route;
  route.how = "closed form over the polygon's edges: Lambert's formula, and Clausen's integral for densities";
  route.enclose = [configuration](const Arguments& arguments, const Rational& radius) -> Outcome<Ball> {
    const Configuration c = configuration(arguments);
    const PlanePolygon polygon = plane_polygon(c.origin, c.first, c.second, {c.part}).value();
    PlanePolynomial<Rational> q(1);
    q(0, 0) = c.density[0];
    q(1, 0) = c.density[1];
    q(0, 1) = c.density[2];
    const Outcome<Ball> integral = point_to_polygon_within(radius, c.point, c.normal, polygon, q);
    if (!integral) return integral;
    const BallPrecision precision(bits_for(radius) + 64);
    return *integral / Ball::pi();
  };
  return route;
}

Route by_double_integral(std::function<Configuration(const Arguments&)> configuration) {
  return by_integral(
      "double integral of the kernel by enclosed Gauss rules", digits_of_a_double_integral,
      [configuration](const Arguments& arguments, const Demand& demand) -> Enclosure {
        const Configuration c = configuration(arguments);
        Surface surface;
        surface.name = "parallelogram";
        surface.charts.push_back(
            make_rectangle({.name = "parallelogram", .piece = "parallelogram"}, c.origin, c.first, c.second));
        const DensityFormula q = density([&c]<class R>(const DensityPoint<R>& at) {
          return from_rational<R>(c.density[0]) + from_rational<R>(c.density[1]) * at.at.s +
                 from_rational<R>(c.density[2]) * at.at.t;
        });
        const Enclosure integral =
            kernel_integral(ExactObserver::off_surface(c.point, c.normal), surface, 0, c.part, q,
                            {.radius = 2 * demand.radius, .work_limit = demand.work_limit});
        if (!integral) return integral;
        return Enclosed{.value = integral->value / Ball::pi(), .evaluations = integral->evaluations};
      });
}

const PolygonLoop unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const PolygonLoop unit_triangle{{0, 0}, {1, 0}, {0, 1}};

/// P = (x, y, height) looks down on [0, width] x [0, depth] in z = 0.
Configuration above_a_rectangle(const Arguments& a) {
  return {.point = {a[0], a[1], a[2]},
          .normal = {0, 0, -1},
          .origin = {0, 0, 0},
          .first = {a[3], 0, 0},
          .second = {0, a[4], 0},
          .part = unit_square,
          .density = {1, 0, 0}};
}

/// P = (x, -distance, height) with n_P = +y, and the same rectangle, y >= 0: it stands at a right angle to
/// the rectangle.
Configuration beside_a_rectangle(const Arguments& a) {
  return {.point = {a[0], -a[1], a[2]},
          .normal = {0, 1, 0},
          .origin = {0, 0, 0},
          .first = {a[3], 0, 0},
          .second = {0, a[4], 0},
          .part = unit_square,
          .density = {1, 0, 0}};
}

/// P = 0 and the triangle (0,0,1) (1,0,1) (0,1,1), seen from below; s = x and t = y.
Configuration below_a_triangle(const Arguments& a) {
  return {.point = {0, 0, 0},
          .normal = {a[0], a[1], 1},
          .origin = {0, 0, 1},
          .first = {0, 1, 0},
          .second = {1, 0, 0},
          .part = unit_triangle,
          .density = {a[2], a[4], a[3]}};
}

ValueParameter not_negative(std::string name, std::string default_text) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a number >= 0",
          .allows = [](const Rational& x) { return x.sign() >= 0; }};
}

}  // namespace

Theme point_factors() {
  const std::string formula = "1/pi Int G(P,Q) q(Q) dS_Q";
  const std::string source = "Lambert's formula; Chen and Arvo 2000 for densities; ac98 (2)";
  const auto half = Rational(1, 2);
  Theme theme;
  theme.families = {
      {.name = "point_above_rectangle",
       .summary =
           "from the point (x, y, height), looking down, to the rectangle [0, width] x [0, depth] in z = 0",
       .formula = formula,
       .source = source,
       .parameters = {any_number("x", "1/2"), any_number("y", "1/2"), positive("height", "1"),
                      positive("width", "1"), positive("depth", "1")},
       .route = by_lambert(above_a_rectangle),
       .second_route = by_double_integral(above_a_rectangle)},
      {.name = "point_beside_rectangle",
       .summary = "from the point (x, -distance, height), looking along y, to the rectangle [0, width] x [0, "
                  "depth] in z = 0",
       .formula = formula,
       .source = source,
       .parameters = {any_number("x", "1/2"), not_negative("distance", "0"), positive("height", "1/2"),
                      positive("width", "1"), positive("depth", "1")},
       .route = by_lambert(beside_a_rectangle),
       .second_route = by_double_integral(beside_a_rectangle)},
      {.name = "point_to_corner_triangle",
       .summary = "from the origin with the normal (normal_x, normal_y, 1), brought to unit length, to the "
                  "triangle (0,0,1), (1,0,1), "
                  "(0,1,1) of density constant + by_x x + by_y y",
       .formula = formula,
       .source = source,
       .parameters = {not_negative("normal_x", "0"), not_negative("normal_y", "0"),
                      any_number("constant", "1"), any_number("by_x", "0"), any_number("by_y", "0")},
       .route = by_lambert(below_a_triangle),
       .second_route = by_double_integral(below_a_triangle)},
  };
  theme.named = {
      {"point_cube_centre_to_opposite", "point_above_rectangle", {half, half, 1, 1, 1}},
      {"point_cube_corner_to_opposite", "point_above_rectangle", {0, 0, 1, 1, 1}},
      {"point_near_the_square_1/100", "point_above_rectangle", {half, half, Rational(1, 100), 1, 1}},
      {"point_off_the_square", "point_above_rectangle", {2, 3, 1, 1, 1}},
      {"point_cube_centre_to_adjacent", "point_beside_rectangle", {half, 0, half, 1, 1}},
      {"point_near_the_edge_1/100", "point_beside_rectangle", {half, 0, Rational(1, 100), 1, 1}},
      {"point_triangle_constant", "point_to_corner_triangle", {0, 0, 1, 0, 0}},
      {"point_triangle_constant_tilted", "point_to_corner_triangle", {1, 1, 1, 0, 0}},
      {"point_triangle_x", "point_to_corner_triangle", {0, 0, 0, 1, 0}},
      {"point_triangle_x_tilted", "point_to_corner_triangle", {1, 1, 0, 1, 0}},
  };
  return theme;
}

}  // namespace radcert::reference::values
