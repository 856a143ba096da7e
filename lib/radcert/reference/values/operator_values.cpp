// SPDX-License-Identifier: GPL-3.0-or-later

// The integral operator without its factor rho/pi, Int_S G(P,Q) u(Q) dS_Q, at points of surfaces of the
// catalogue.
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/reference/values/families.h"
#include "radcert/reference/values/line.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/tetrahedron.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert::reference::values {
namespace {

const Rational half(1, 2);

/// Over charts with P on one of them the integrals take seconds for each ten digits.
constexpr int digits_on_curved_pieces = 20;
constexpr int digits_off_the_piece = 40;

Route pi_by_the_divergence_theorem() {
  return by_formula("Int_S G = pi on a closed convex surface, by the divergence theorem",
                    [](const Arguments&) { return Ball::pi(); });
}

/// From the point (x, y, 0) of the face z = 0 of the box [0, width] x [0, depth] x [0, height] to the other
/// five, each a polygon.
Outcome<Ball> over_the_faces_of_a_box(const Arguments& a, const Rational& radius) {
  const Rational &w = a[2], &d = a[3], &h = a[4];
  using Point = Vector<Rational>;
  const std::vector<std::vector<Point>> faces = {{{0, 0, h}, {0, d, h}, {w, d, h}, {w, 0, h}},
                                                 {{0, 0, 0}, {0, d, 0}, {0, d, h}, {0, 0, h}},
                                                 {{w, 0, 0}, {w, 0, h}, {w, d, h}, {w, d, 0}},
                                                 {{0, 0, 0}, {0, 0, h}, {w, 0, h}, {w, 0, 0}},
                                                 {{0, d, 0}, {w, d, 0}, {w, d, h}, {0, d, h}}};
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  const BallPrecision precision(bits_for(radius) + 64);
  Ball sum;
  for (const std::vector<Point>& face : faces) {
    const Outcome<Ball> part = point_to_polygon_within(radius / Rational(6), {a[0] * w, a[1] * d, 0},
                                                       {0, 0, 1}, plane_polygon(face).value(), one);
    if (!part) return part;
    sum += *part;
  }
  return sum;
}

/// P on the first octant of an ellipsoid at the parameters (s,t).
Enclosure over_an_ellipsoid(const Surface& surface, const Rational& s, const Rational& t,
                            const DensityFormula& q, const Demand& demand) {
  return kernel_integral(ExactObserver::on_surface({{.chart = 0, .at = {s, t}}}), surface, q, demand);
}

/// Over the roof of two_piece from (x, y, 0): with v = eta - y, A = (xi - x)^2 + z^2, z = 2 - xi^p, the
/// kernel times the area element is z (z + p xi^(p-1) (xi - x)) / (A + v^2)^2, and v is integrated in closed
/// form: Int 1/(A + v^2)^2 = v/(2A(A + v^2)) + atan(v/sqrt A)/(2 A^(3/2)),  Int v/(A + v^2)^2 = -1/(2(A +
/// v^2)), Int v^2/(A + v^2)^2 = -v/(2(A + v^2)) + atan(v/sqrt A)/(2 sqrt A).
enum class RoofDensity { one, squared_radius };
Enclosure over_the_roof(const Arguments& a, RoofDensity density, const Demand& demand) {
  const auto f = [a, density]<class R>(const R& xi) {
    const long p = *a[0].to_long();
    const R y = in<R>(a[2]);
    const R offset = xi - in<R>(a[1]);
    const R z = R(2) - power(xi, p);
    const R square = offset * offset + z * z;
    const R root = sqrt(square);
    const auto between = [&](const auto& primitive) { return primitive(R(1) - y) - primitive(-y); };
    const R zeroth = between([&](const R& v) {
      return v / (R(2) * square * (square + v * v)) + atan(v / root) / (R(2) * square * root);
    });
    R value = zeroth;
    if (density == RoofDensity::squared_radius) {
      const R first = between([&](const R& v) { return -(R(1) / (R(2) * (square + v * v))); });
      const R second =
          between([&](const R& v) { return atan(v / root) / (R(2) * root) - v / (R(2) * (square + v * v)); });
      value = (xi * xi + y * y + z * z) * zeroth + R(2) * y * first + second;
    }
    return z * (z + R(p) * power(xi, p - 1) * offset) * value;
  };
  return times_integral(Ball(1), f, Ball(0), Ball(1), demand);
}

Enclosure over_the_roof_chart(const Arguments& a, RoofDensity density, const Demand& demand) {
  const DensityFormula one = unit_density();
  const DensityFormula squared_radius = radcert::density([]<class R>(const DensityPoint<R>& q) {
    return q.point.x * q.point.x + q.point.y * q.point.y + q.point.z * q.point.z;
  });
  const Surface surface = two_piece(a[0]);
  return kernel_integral(ExactObserver::on_surface({{.chart = 0, .at = {a[1], a[2]}}}), surface, 1,
                         domain_polygon(surface.charts[1]),
                         density == RoofDensity::one ? one : squared_radius, demand);
}

ValueFamily roof_family(std::string name, const std::string& u, RoofDensity density) {
  const auto part = [](std::string parameter) {
    return ValueParameter{.name = std::move(parameter),
                          .default_text = "1/2",
                          .allowed = "a number in [0, 1]",
                          .allows = [](const Rational& x) { return Rational(0) <= x && x <= Rational(1); }};
  };
  return {
      .name = std::move(name),
      .summary = "Int G u over two_piece from the point (x, y, 0) of its lower square, u = " + u,
      .formula = "Int_S G(P,Q) u(Q) dS_Q, u = " + u,
      .source = "ac98 (94)",
      .parameters = {whole("p", "2", 1, 20), part("x"), part("y")},
      .route = by_integral(
          "integral along x, that along y in closed form", 300,
          [density](const Arguments& a, const Demand& demand) { return over_the_roof(a, density, demand); }),
      .second_route = by_integral("double integral over the chart by enclosed Gauss rules",
                                  digits_off_the_piece, [density](const Arguments& a, const Demand& demand) {
                                    return over_the_roof_chart(a, density, demand);
                                  })};
}

const std::string total = "Int_S G(P,Q) dS_Q";

ValueParameter inside(std::string name) { return strictly_between(std::move(name), "1/5", 0, half); }

/// Int G over a surface from the point of its last chart with the parameters s, t, which follow the surface's
/// own.
ValueFamily total_family(const std::string& surface_name, const std::string& piece,
                         std::vector<ValueParameter> parameters, Route route,
                         std::function<Surface(const Arguments&)> surface) {
  parameters.push_back(inside("s"));
  parameters.push_back(inside("t"));
  const auto integral = [surface](const Arguments& a, const Demand& demand) {
    const Surface s = surface(a);
    const ParameterPoint<Rational> at{a[a.size() - 2], a[a.size() - 1]};
    return kernel_integral(ExactObserver::on_surface({{.chart = s.charts.size() - 1, .at = at}}), s,
                           unit_density(), demand);
  };
  return {.name = surface_name + "_total",
          .summary = "Int G over " + surface_name + " from the point of its " + piece +
                     " with the parameters s, t in its last chart",
          .formula = total,
          .source = "ac98 (7)",
          .parameters = std::move(parameters),
          .route = std::move(route),
          .second_route = by_integral("double integrals over the charts, chords divided at P",
                                      digits_on_curved_pieces, integral)};
}

}  // namespace

Theme operator_values() {
  Theme theme;
  theme.families = {
      {.name = "box_total",
       .summary = "Int G over a box from the point (x width, y depth, 0) of its floor",
       .formula = total,
       .source = "ac98 (7)",
       .parameters = {strictly_between("x", "1/2", 0, 1), strictly_between("y", "1/2", 0, 1),
                      positive("width", "1"), positive("depth", "1"), positive("height", "1")},
       .route = pi_by_the_divergence_theorem(),
       .second_route = {.how = "Lambert's formula over five faces", .enclose = over_the_faces_of_a_box}},
      {.name = "ellipsoid_total",
       .summary = "Int G over an ellipsoid with half axes a, b, c from the point of its first octant with "
                  "the parameters s, t",
       .formula = total,
       .source = "ac98 (7); m06 Lemma 1 (c)",
       .parameters = {positive("a", "1"), positive("b", "1"), positive("c", "1"), inside("s"), inside("t")},
       .route = pi_by_the_divergence_theorem(),
       .second_route = by_integral(
           "double integrals over eight charts, chords divided at P", digits_on_curved_pieces,
           [](const Arguments& a, const Demand& demand) {
             return over_an_ellipsoid(ellipsoid(a[0], a[1], a[2]), a[3], a[4], unit_density(), demand);
           })},
      {.name = "sphere_power",
       .summary = "Int G z^k over the unit sphere from the point of its first octant with the parameters s, "
                  "t, k even",
       .formula = "Int_S G(P,Q) z_Q^k dS_Q = pi/(k + 1)",
       .source = "m06 Lemma 1 (d)",
       .parameters = {{.name = "k",
                       .default_text = "2",
                       .allowed = "an even whole number from 0 to 20",
                       .allows =
                           [](const Rational& k) {
                             return (k / Rational(2)).is_integer() && k.sign() >= 0 && k <= Rational(20);
                           }},
                      inside("s"),
                      inside("t")},
       .route = by_formula("G = 1/4 on the unit sphere",
                           [](const Arguments& a) { return Ball::pi() / Ball(a[0] + Rational(1)); }),
       .second_route =
           by_integral("double integrals over eight charts, chords divided at P", digits_on_curved_pieces,
                       [](const Arguments& a, const Demand& demand) {
                         const long k = *a[0].to_long();
                         const DensityFormula z =
                             density([k]<class R>(const DensityPoint<R>& q) { return power(q.point.z, k); });
                         return over_an_ellipsoid(sphere(), a[1], a[2], z, demand);
                       })},
      roof_family("two_piece_total", "1", RoofDensity::one),
      roof_family("two_piece_operator", "x^2 + y^2 + z^2", RoofDensity::squared_radius),
      total_family("cylinder", "mantle", {positive("radius", "1"), positive("height", "1")},
                   pi_by_the_divergence_theorem(), [](const Arguments& a) { return cylinder(a[0], a[1]); }),
      total_family("cone", "mantle", {positive("radius", "2"), positive("top", "1"), positive("height", "1")},
                   pi_by_the_divergence_theorem(), [](const Arguments& a) { return cone(a[0], a[1], a[2]); }),
      total_family("paraboloid_cap", "cap", {}, pi_by_the_divergence_theorem(),
                   [](const Arguments&) { return paraboloid_cap(); }),
      total_family("tetrahedron", "last face", {}, pi_by_the_divergence_theorem(),
                   [](const Arguments&) { return tetrahedron(); }),
      total_family("octahedron", "last face", {}, pi_by_the_divergence_theorem(),
                   [](const Arguments&) { return octahedron(); }),
      total_family("spherical_cap", "cap",
                   {strictly_between("fraction", "1/4", Rational(1, 1000), Rational(999, 1000))},
                   by_formula("G = 1/4 over a part of the unit sphere of area 4 pi fraction",
                              [](const Arguments& a) { return Ball::pi() * Ball(a[0]); }),
                   [](const Arguments& a) { return spherical_cap(a[0]); }),
  };
  const Rational fifth(1, 5);
  const Rational third(1, 3);
  theme.named = {
      {"cube_total_at_centre", "box_total", {half, half, 1, 1, 1}},
      {"cube_total_near_a_corner", "box_total", {Rational(1, 100), Rational(1, 100), 1, 1, 1}},
      {"box_1_2_3_total", "box_total", {third, fifth, 1, 2, 3}},
      {"sphere_total", "ellipsoid_total", {1, 1, 1, fifth, third}},
      {"ellipsoid_1_2_5_total", "ellipsoid_total", {1, 2, 5, fifth, third}},
      {"sphere_z_squared", "sphere_power", {2, fifth, third}},
      {"cylinder_1_1_total", "cylinder_total", {1, 1, fifth, third}},
      {"cone_2_1_1_total", "cone_total", {2, 1, 1, fifth, third}},
      {"paraboloid_cap_total_of_its_cap", "paraboloid_cap_total", {fifth, third}},
      {"tetrahedron_total_of_a_face", "tetrahedron_total", {fifth, third}},
      {"octahedron_total_of_a_face", "octahedron_total", {fifth, third}},
      {"spherical_cap_1/4_total", "spherical_cap_total", {Rational(1, 4), fifth, third}},
      {"two_piece_2_total_at_centre", "two_piece_total", {2, half, half}},
      {"two_piece_3_total_at_centre", "two_piece_total", {3, half, half}},
      {"two_piece_2_total_at_corner", "two_piece_total", {2, 0, 0}},
      {"two_piece_2_squared_radius_at_centre", "two_piece_operator", {2, half, half}},
      {"two_piece_3_squared_radius_at_corner", "two_piece_operator", {3, 1, 0}},
  };
  return theme;
}

}  // namespace radcert::reference::values
