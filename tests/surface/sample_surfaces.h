// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert::testing {

/// A surface of the catalogue with what a test knows of it from elsewhere: its formulas in long double, its
/// area and volume.
struct SampleSurface {
  std::string entry;
  std::vector<Rational> values;
  std::vector<std::shared_ptr<const ChartIn<long double>>> charts{};
  std::optional<double> area = std::nullopt;
  std::optional<double> volume = std::nullopt;

  Surface make() const { return find_surface(entry)->make(values); }
};

namespace detail {

using LongChart = std::shared_ptr<const ChartIn<long double>>;

template <template <class> class Formula, class... Arguments>
LongChart long_chart(Orientation orientation, const Arguments&... arguments) {
  return std::make_shared<ChartOf<long double, Formula<long double>>>(Formula<long double>(arguments...),
                                                                      orientation);
}

inline LongChart long_rectangle(Orientation orientation, const Vector<Rational>& origin,
                                const Vector<Rational>& first, const Vector<Rational>& second) {
  return long_chart<Rectangle>(orientation, origin, first, second);
}

inline std::vector<LongChart> long_box(const Rational& a, const Rational& b, const Rational& c) {
  constexpr Orientation along = Orientation::along_the_cross_product;
  constexpr Orientation against = Orientation::against_the_cross_product;
  const Vector<Rational> o{0, 0, 0};
  const Vector<Rational> x{a, 0, 0};
  const Vector<Rational> y{0, b, 0};
  const Vector<Rational> z{0, 0, c};
  return {long_rectangle(along, o, y, z), long_rectangle(against, x, y, z),
          long_rectangle(along, o, z, x), long_rectangle(against, y, z, x),
          long_rectangle(along, o, x, y), long_rectangle(against, z, x, y)};
}

inline std::vector<LongChart> long_ellipsoid(const Rational& a, const Rational& b, const Rational& c) {
  std::vector<LongChart> charts;
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1})
        charts.push_back(long_chart<EllipsoidOctant>(
            x * y * z > 0 ? Orientation::against_the_cross_product : Orientation::along_the_cross_product, a,
            b, c, Octant{x, y, z}));
  return charts;
}

constexpr Orientation with_sign(int sign) {
  return sign > 0 ? Orientation::along_the_cross_product : Orientation::against_the_cross_product;
}

/// Signs of the quadrants, counter-clockwise.
inline std::vector<Quadrant> around() { return {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}; }

/// `up`: 1 where the inner normal points up, -1 where it points down.
inline void append_disk(std::vector<LongChart>& charts, const Rational& radius, const Rational& height,
                        int up) {
  for (const Quadrant& q : around())
    charts.push_back(long_chart<DiskQuadrant>(with_sign(up * q.x * q.y), radius, height, q));
}

inline std::vector<LongChart> long_cone(const Rational& radius, const Rational& top, const Rational& height) {
  std::vector<LongChart> charts;
  append_disk(charts, radius, 0, 1);
  append_disk(charts, top, height, -1);
  for (const Quadrant& q : around())
    charts.push_back(long_chart<ConeMantle>(with_sign(-q.x * q.y), radius, top, height, q));
  return charts;
}

inline std::vector<LongChart> long_paraboloid_cap() {
  std::vector<LongChart> charts;
  append_disk(charts, 1, 0, 1);
  for (const Quadrant& q : around())
    charts.push_back(long_chart<ParaboloidQuadrant>(with_sign(-q.x * q.y), q));
  return charts;
}

inline std::vector<LongChart> long_spherical_cap(const Rational& fraction) {
  std::vector<LongChart> charts;
  for (const Quadrant& q : around())
    charts.push_back(long_chart<SphericalCapQuadrant>(with_sign(-q.x * q.y), fraction, q));
  return charts;
}

inline std::vector<LongChart> long_torus(const Rational& radius, const Rational& ratio) {
  std::vector<LongChart> charts;
  for (const Quadrant& q : around())
    for (const Quadrant& tube : around())
      charts.push_back(
          long_chart<TorusPatch>(with_sign(-q.x * q.y * tube.x * tube.y), radius, ratio, q, tube));
  return charts;
}

inline LongChart long_triangle(int sign, const Vector<Rational>& a, const Vector<Rational>& b,
                               const Vector<Rational>& c) {
  return long_rectangle(with_sign(sign), a, b - a, c - a);
}

/// The corners of each face in the order (1,2,3), (2,3,0), (3,0,1), (0,1,2); (b-a) x (c-a) points outwards,
/// inwards, ...
inline std::vector<LongChart> long_tetrahedron() {
  const Vector<Rational> a{1, 1, 1};
  const Vector<Rational> b{1, -1, -1};
  const Vector<Rational> c{-1, 1, -1};
  const Vector<Rational> d{-1, -1, 1};
  return {long_triangle(1, b, c, d), long_triangle(-1, c, d, a), long_triangle(1, d, a, b),
          long_triangle(-1, a, b, c)};
}

inline std::vector<LongChart> long_octahedron() {
  std::vector<LongChart> charts;
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1})
        charts.push_back(long_triangle(-x * y * z, {x, 0, 0}, {0, y, 0}, {0, 0, z}));
  return charts;
}

}  // namespace detail

inline SampleSurface sample_box(const std::string& entry, const std::vector<Rational>& values,
                                const Rational& a, const Rational& b, const Rational& c) {
  return {.entry = entry,
          .values = values,
          .charts = detail::long_box(a, b, c),
          .area = (Rational(2) * (a * b + b * c + c * a)).to_double(),
          .volume = (a * b * c).to_double()};
}

inline SampleSurface sample_ellipsoid(const std::string& entry, const std::vector<Rational>& values,
                                      const Rational& a, const Rational& b, const Rational& c,
                                      std::optional<double> area) {
  return {.entry = entry,
          .values = values,
          .charts = detail::long_ellipsoid(a, b, c),
          .area = area,
          .volume = 4 * std::numbers::pi / 3 * (a * b * c).to_double()};
}

inline SampleSurface sample_two_piece(const Rational& p, std::optional<double> area_of_roof) {
  SampleSurface sample{.entry = "two_piece", .values = {p}};
  sample.charts.push_back(
      detail::long_rectangle(Orientation::along_the_cross_product, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  sample.charts.push_back(detail::long_chart<PowerRoof>(Orientation::against_the_cross_product, p));
  if (area_of_roof) sample.area = 1 + *area_of_roof;
  return sample;
}

/// A truncated cone, or a cylinder: pi (r^2 + t^2 + (r + t) sqrt((r-t)^2 + h^2)) and pi h (r^2 + r t +
/// t^2)/3.
inline SampleSurface sample_cone(const std::string& entry, const std::vector<Rational>& values,
                                 const Rational& radius, const Rational& top, const Rational& height) {
  const double r = radius.to_double();
  const double t = top.to_double();
  const double h = height.to_double();
  return {.entry = entry,
          .values = values,
          .charts = detail::long_cone(radius, top, height),
          .area = std::numbers::pi * (r * r + t * t + (r + t) * std::hypot(r - t, h)),
          .volume = std::numbers::pi * h * (r * r + r * t + t * t) / 3};
}

/// Every entry of the catalogue, with several parameters.
inline std::vector<SampleSurface> sample_surfaces() {
  using std::numbers::pi;
  std::vector<SampleSurface> all;
  const Vector<Rational> o{0, 0, 0};
  const Vector<Rational> x{1, 0, 0};
  all.push_back({.entry = "two_squares",
                 .values = {},
                 .charts = {detail::long_rectangle(Orientation::against_the_cross_product, o, x, {0, 0, 1}),
                            detail::long_rectangle(Orientation::along_the_cross_product, o, x, {0, 1, 0})},
                 .area = 2});
  // Areas of the roof: sqrt(2);  Int sqrt(1 + 4 x^2);  Int sqrt(1 + 9 x / 4)
  all.push_back(sample_two_piece(1, std::sqrt(2.0)));
  all.push_back(sample_two_piece(2, std::sqrt(5.0) / 2 + std::asinh(2.0) / 4));
  all.push_back(sample_two_piece(Rational(3, 2), 8.0 / 27 * (std::pow(13.0 / 4, 1.5) - 1)));
  all.push_back(sample_two_piece(Rational(7, 3), std::nullopt));
  all.push_back(sample_box("cube", {}, 1, 1, 1));
  all.push_back(sample_box("box", {1, 2, 5}, 1, 2, 5));
  all.push_back(sample_box("box", {Rational(1, 10), 3, Rational(2, 7)}, Rational(1, 10), 3, Rational(2, 7)));
  all.push_back(sample_ellipsoid("sphere", {}, 1, 1, 1, 4 * pi));
  all.push_back(sample_ellipsoid("ellipsoid", {1, 2, 5}, 1, 2, 5, std::nullopt));
  // The prolate spheroid: 2 pi (1 + c asin(e) / e), e^2 = 1 - 1/c^2
  const double e = std::sqrt(0.75);
  all.push_back(sample_ellipsoid("ellipsoid", {1, 1, 2}, 1, 1, 2, 2 * pi * (1 + 2 / e * std::asin(e))));
  all.push_back(sample_ellipsoid("ellipsoid", {3, Rational(1, 3), Rational(1, 2)}, 3, Rational(1, 3),
                                 Rational(1, 2), std::nullopt));
  for (const Rational& fraction : {Rational(1, 4), Rational(1, 2), Rational(9, 10), Rational(1, 20)})
    all.push_back({.entry = "spherical_cap",
                   .values = {fraction},
                   .charts = detail::long_spherical_cap(fraction),
                   .area = 4 * pi * fraction.to_double()});
  all.push_back(sample_cone("cylinder", {1, 2}, 1, 1, 2));
  all.push_back(sample_cone("cylinder", {3, Rational(1, 5)}, 3, 3, Rational(1, 5)));
  all.push_back(sample_cone("cone", {1, Rational(1, 2), 1}, 1, Rational(1, 2), 1));
  all.push_back(sample_cone("cone", {Rational(1, 3), 2, Rational(7, 3)}, Rational(1, 3), 2, Rational(7, 3)));
  // The paraboloid: 2 pi Int r sqrt(1 + 4 r^2) dr = pi/6 (5 sqrt(5) - 1), and below it pi/2.
  all.push_back({.entry = "paraboloid_cap",
                 .values = {},
                 .charts = detail::long_paraboloid_cap(),
                 .area = pi + pi / 6 * (5 * std::sqrt(5.0) - 1),
                 .volume = pi / 2});
  // Edges of length a = 2 sqrt(2) and sqrt(2): areas sqrt(3) a^2 and 2 sqrt(3) a^2.
  all.push_back({.entry = "tetrahedron",
                 .values = {},
                 .charts = detail::long_tetrahedron(),
                 .area = 8 * std::sqrt(3.0),
                 .volume = 8.0 / 3});
  all.push_back({.entry = "octahedron",
                 .values = {},
                 .charts = detail::long_octahedron(),
                 .area = 4 * std::sqrt(3.0),
                 .volume = 4.0 / 3});
  // Pappus: 4 pi^2 R r and 2 pi^2 R r^2.
  all.push_back({.entry = "torus",
                 .values = {1, Rational(1, 2)},
                 .charts = detail::long_torus(1, Rational(1, 2)),
                 .area = 2 * pi * pi,
                 .volume = pi * pi / 2});
  all.push_back({.entry = "torus",
                 .values = {3, Rational(1, 7)},
                 .charts = detail::long_torus(3, Rational(1, 7)),
                 .area = 36 * pi * pi / 7,
                 .volume = 54 * pi * pi / 49});
  return all;
}

/// Points of a chart's domain: its corners, points of its sides, near them and inside.
inline std::vector<ParameterPoint<double>> sample_points(ChartDomain domain) {
  std::vector<ParameterPoint<double>> points;
  for (const double s : {0.0, 1e-7, 0.2, 0.5, 0.81, 1.0})
    for (const double t : {0.0, 1e-5, 0.3, 0.5, 1.0})
      if (domain == ChartDomain::unit_square) {
        points.push_back({s, t});
      } else {
        points.push_back({s, t * (1 - s)});
      }
  return points;
}

}  // namespace radcert::testing
