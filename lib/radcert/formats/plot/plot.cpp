// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {

namespace {

constexpr double least_length = 1e-6;  // of an axis, relative: far above the rounding of its ticks

/// A whole multiple of a power of ten, as near as double holds.
double decimal(double multiple, int power) {
  return parse_double(shortest(multiple) + "e" + std::to_string(power)).value_or(0);
}

/// Multiples of 1, 2 or 5 times a power of ten: the widest step that leaves four ticks at least.
std::vector<double> even_ticks(double least, double largest) {
  constexpr double enough = 4;
  constexpr int largest_power = 307;  // five times that is still a double
  int power = std::min(static_cast<int>(std::ceil(std::log10(largest - least))), largest_power);
  double step = 1;
  const auto fits = [&](double multiple, int exponent) {
    const double width = decimal(multiple, exponent);
    expects(width > 0, "an axis no shorter than the least double", named("least", least),
            named("largest", largest));
    return std::floor(largest / width) - std::ceil(least / width) + 1 >= enough;
  };
  while (!fits(step, power)) {
    if (step == 1) --power;
    step = step == 1 ? 5 : (step == 5 ? 2 : 1);
  }
  std::vector<double> ticks;
  const double width = decimal(step, power);
  for (double k = std::ceil(least / width); k <= std::floor(largest / width); ++k)
    ticks.push_back(decimal(k * step, power));
  return ticks;
}

/// The range of an axis: the data's, and a twentieth of it on either side; a single value lies in the middle
/// of a range.
std::pair<double, double> range_of(const std::vector<double>& values, bool logarithmic) {
  if (values.empty()) return {1, 10};
  constexpr double margin = 0.05;
  constexpr double single = 2;         // the factor, or length, on either side of a single value
  constexpr double least_room = 1e-3;  // relative: keeps ticks apart where values hardly differ
  const double least = *std::min_element(values.begin(), values.end());
  const double largest = *std::max_element(values.begin(), values.end());
  if (!logarithmic) {
    const double room =
        std::max(margin * (largest - least), least_room * std::max(std::abs(least), std::abs(largest)));
    return least < largest ? std::pair{least - room, largest + room}
                           : std::pair{least - single, least + single};
  }
  const double factor =
      least < largest ? std::max(std::pow(largest / least, margin), 1 + least_room) : single;
  return {std::max(least / factor, std::numeric_limits<double>::min()),
          std::min(largest * factor, std::numeric_limits<double>::max())};
}

/// How far a triangle stands off its curve, as part of the plot's height.
constexpr double distance = 0.05;

/// Below this exponent a triangle is a line.
constexpr double least_exponent = 0.25;

std::optional<SlopeTriangle> triangle(const PlotCurve& curve, double height, bool above) {
  const PlotPoint& fine = curve.points.back();
  const PlotPoint& coarse = curve.points[curve.points.size() - 2];
  const double ratio = coarse.x / fine.x;
  const double slope = *curve.exponent;
  // Of a finer point x is smaller where errors grow with it, and larger where they fall.
  if (std::abs(slope) < least_exponent || !(slope > 0 ? ratio > 1 : ratio < 1)) return std::nullopt;
  const double shift = std::pow(height, above ? distance : -distance);
  const auto [low, high] = std::minmax({std::pow(ratio, 0.25), std::pow(ratio, 0.75)});
  return SlopeTriangle{.x = {fine.x * low, fine.x * high},
                       .y = {fine.y * shift * std::pow(low, slope), fine.y * shift * std::pow(high, slope)},
                       .exponent = slope,
                       .above = above};
}

}  // namespace

std::string tick_text(double value) {
  const double size = std::abs(value);
  if (size == 0 || (size >= 1e-3 && size < 1e6)) {
    // Without an exponent: the shortest form of 100000 is 1e+05.
    if (value == std::floor(value)) return std::to_string(static_cast<long long>(value));
    return shortest(value);
  }
  std::string text = shortest(value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string power = text.substr(e + 1);
  const bool negative = power.front() == '-';
  power.erase(0, power.find_first_not_of("+-0"));
  return text.substr(0, e) + "e" + (negative ? "-" : "") + power;
}

std::vector<double> axis_ticks(double least, double largest, bool logarithmic) {
  expects(std::isfinite(least) && std::isfinite(largest) && (!logarithmic || least > 0) &&
              largest - least > least_length * std::max(std::abs(least), std::abs(largest)),
          "an axis with a length", named("least", least), named("largest", largest));
  if (!logarithmic) return even_ticks(least, largest);
  const int first = static_cast<int>(std::floor(std::log10(least))) - 1;
  const int last = static_cast<int>(std::ceil(std::log10(largest)));
  constexpr double few_decades = 4;
  constexpr double many_decades = 12;
  const double decades = std::log10(largest / least);
  std::vector<double> ticks;
  for (int power = first; power <= last; ++power) {
    if (decades > many_decades && power % 3 != 0) continue;
    for (const double multiple : {1.0, 2.0, 5.0}) {
      if (multiple != 1 && decades >= few_decades) continue;
      const double tick = decimal(multiple, power);
      if (least <= tick && tick <= largest) ticks.push_back(tick);
    }
  }
  return ticks.size() < 3 ? even_ticks(least, largest) : ticks;
}

PlotRange shown_range(const Plot& plot) {
  constexpr double least = std::numeric_limits<double>::min();
  std::vector<double> xs;
  std::vector<double> ys;
  for (const PlotCurve& curve : plot.curves)
    for (const auto& [x, y, radius] : curve.points) {
      expects(std::isfinite(x) && std::isfinite(y) && (!plot.y.logarithmic || y >= least) &&
                  (!plot.x.logarithmic || x >= least),
              "finite points, normal and positive on logarithmic axes", named("x", x), named("y", y));
      expects(radius >= 0, "a radius that is not negative", named("radius", radius));
      xs.push_back(x);
      ys.push_back(y);
    }
  for (const PlotMark& mark : plot.marks) xs.push_back(mark.x);
  for (const SlopeTriangle& triangle : slope_triangles(plot))
    ys.insert(ys.end(), triangle.y.begin(), triangle.y.end());
  return {.x = plot.x.range.value_or(range_of(xs, plot.x.logarithmic)),
          .y = plot.y.range.value_or(range_of(ys, plot.y.logarithmic))};
}

std::vector<SlopeTriangle> slope_triangles(const Plot& plot) {
  std::vector<SlopeTriangle> out;
  if (!plot.x.logarithmic || !plot.y.logarithmic) return out;
  double least = 0;
  double largest = 0;
  const PlotCurve* lowest = nullptr;
  const PlotCurve* highest = nullptr;
  for (const PlotCurve& curve : plot.curves) {
    for (const PlotPoint& at : curve.points) {
      least = least == 0 ? at.y : std::min(least, at.y);
      largest = std::max(largest, at.y);
    }
    if (!curve.exponent || curve.points.size() < 2) continue;
    if (lowest == nullptr || curve.points.back().y < lowest->points.back().y) lowest = &curve;
    if (highest == nullptr || curve.points.back().y > highest->points.back().y) highest = &curve;
  }
  if (lowest == nullptr) return out;
  const double height = largest / least;
  if (const auto one = triangle(*lowest, height, false)) out.push_back(*one);
  constexpr double alike = 0.1;
  if (std::abs(*highest->exponent - *lowest->exponent) > alike)
    if (const auto one = triangle(*highest, height, true)) out.push_back(*one);
  return out;
}

}  // namespace radcert
