// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "radcert/surface/catalogue.h"

namespace radcert::testing {

/// A surface of the catalogue with what is known of it from elsewhere.
struct SampleSurface {
  std::string entry;
  std::vector<Rational> values{};
  std::optional<double> area = std::nullopt;
  std::optional<double> volume = std::nullopt;

  Surface make() const { return find_surface(entry)->make(values); }
};

inline SampleSurface sample_box(const std::string& entry, const std::vector<Rational>& values, double a,
                                double b, double c) {
  return {.entry = entry, .values = values, .area = 2 * (a * b + b * c + c * a), .volume = a * b * c};
}

inline SampleSurface sample_ellipsoid(const Rational& a, const Rational& b, const Rational& c,
                                      std::optional<double> area) {
  return {.entry = "ellipsoid",
          .values = {a, b, c},
          .area = area,
          .volume = 4 * std::numbers::pi / 3 * (a * b * c).to_double()};
}

/// The unit square and its roof.
inline SampleSurface sample_two_piece(const Rational& p, double area_of_roof) {
  return {.entry = "two_piece", .values = {p}, .area = 1 + area_of_roof};
}

/// A truncated cone, or a cylinder: pi (r^2 + t^2 + (r + t) sqrt((r-t)^2 + h^2)) and pi h (r^2 + r t +
/// t^2)/3.
inline SampleSurface sample_cone(const std::string& entry, const std::vector<Rational>& values, double r,
                                 double t, double h) {
  return {.entry = entry,
          .values = values,
          .area = std::numbers::pi * (r * r + t * t + (r + t) * std::hypot(r - t, h)),
          .volume = std::numbers::pi * h * (r * r + r * t + t * t) / 3};
}

/// Pappus: 4 pi^2 R r and 2 pi^2 R r^2, for r = ratio R.
inline SampleSurface sample_torus(const Rational& radius, const Rational& ratio) {
  using std::numbers::pi;
  const double tube = (radius * ratio).to_double();
  return {.entry = "torus",
          .values = {radius, ratio},
          .area = 4 * pi * pi * radius.to_double() * tube,
          .volume = 2 * pi * pi * radius.to_double() * tube * tube};
}

/// Every entry of the catalogue with its default parameters, and before these what more is known of some.
inline std::vector<SampleSurface> sample_surfaces() {
  using std::numbers::pi;
  // Areas of the roof: sqrt(2);  Int sqrt(1 + 4 x^2);  Int sqrt(1 + 9 x / 4)
  // The prolate spheroid: 2 pi (1 + c asin(e) / e), e^2 = 1 - 1/c^2
  const double e = std::sqrt(0.75);
  std::vector<SampleSurface> all{
      {.entry = "two_squares", .area = 2},
      sample_two_piece(1, std::sqrt(2.0)),
      sample_two_piece(2, std::sqrt(5.0) / 2 + std::asinh(2.0) / 4),
      sample_two_piece(Rational(3, 2), 8.0 / 27 * (std::pow(13.0 / 4, 1.5) - 1)),
      {.entry = "two_piece", .values = {Rational(7, 3)}},
      sample_box("cube", {}, 1, 1, 1),
      sample_box("box", {1, 2, 5}, 1, 2, 5),
      sample_box("box", {Rational(1, 10), 3, Rational(2, 7)}, 0.1, 3, 2.0 / 7),
      {.entry = "sphere", .area = 4 * pi, .volume = 4 * pi / 3},
      sample_ellipsoid(1, 2, 5, std::nullopt),
      sample_ellipsoid(1, 1, 2, 2 * pi * (1 + 2 / e * std::asin(e))),
      sample_ellipsoid(3, Rational(1, 3), Rational(1, 2), std::nullopt),
      sample_cone("cylinder", {1, 2}, 1, 1, 2),
      sample_cone("cylinder", {3, Rational(1, 5)}, 3, 3, 0.2),
      sample_cone("cone", {1, Rational(1, 2), 1}, 1, 0.5, 1),
      sample_cone("cone", {Rational(1, 3), 2, Rational(7, 3)}, 1.0 / 3, 2, 7.0 / 3),
      // 2 pi Int r sqrt(1 + 4 r^2) dr = pi/6 (5 sqrt(5) - 1), and below it pi/2.
      {.entry = "paraboloid_cap", .area = pi + pi / 6 * (5 * std::sqrt(5.0) - 1), .volume = pi / 2},
      // Edges of length a = 2 sqrt(2) and sqrt(2): areas sqrt(3) a^2 and 2 sqrt(3) a^2.
      {.entry = "tetrahedron", .area = 8 * std::sqrt(3.0), .volume = 8.0 / 3},
      {.entry = "octahedron", .area = 4 * std::sqrt(3.0), .volume = 4.0 / 3},
      sample_torus(1, Rational(1, 2)),
      sample_torus(3, Rational(1, 7))};
  for (const Rational& fraction : {Rational(1, 4), Rational(1, 2), Rational(9, 10), Rational(1, 20)})
    all.push_back({.entry = "spherical_cap", .values = {fraction}, .area = 4 * pi * fraction.to_double()});
  for (const SurfaceDescription& entry : surface_catalogue()) {
    SampleSurface sample{.entry = entry.name};
    for (const ParameterDescription& parameter : entry.parameters)
      sample.values.push_back(Rational::parse(parameter.default_text).value());
    all.push_back(std::move(sample));
  }
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
