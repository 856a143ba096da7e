// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double largest_lightness = 0.97;

/// The parts a, b of OKLab at x = 0, 1/6, ..., 1: within sRGB at the lightness there.
struct Chroma {
  double a;
  double b;
};
constexpr std::array<Chroma, 7> path{{{0, 0},
                                      {0.028, -0.072},
                                      {0.012, -0.12},
                                      {-0.062, -0.052},
                                      {-0.112, 0.05},
                                      {-0.085, 0.13},
                                      {-0.04, 0.11}}};

}  // namespace

Colour colour_of_oklab(double lightness, double a, double b) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

Colour map_colour(double x) {
  expects(!std::isnan(x), "a number to show");
  const double shown = std::clamp(x, 0.0, 1.0);
  const double at = shown * static_cast<double>(path.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), path.size() - 2);
  const double part = at - static_cast<double>(k);
  return colour_of_oklab(largest_lightness * shown, (1 - part) * path[k].a + part * path[k + 1].a,
                         (1 - part) * path[k].b + part * path[k + 1].b);
}

}  // namespace radcert
