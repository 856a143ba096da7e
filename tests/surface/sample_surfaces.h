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
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert::testing {

/// A surface of the catalogue with what a test knows of it from elsewhere: its formulas in long double, its area and volume.
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
