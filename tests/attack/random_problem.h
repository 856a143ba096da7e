// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/surface/catalogue.h"
#include "tests/scalar/draw.h"

namespace radcert::attack {

/// A surface of the catalogue with parameters, some at the ends of their ranges.
struct RandomSurface {
  const SurfaceDescription* description = nullptr;
  std::vector<Rational> values;

  [[nodiscard]] Surface made() const { return description->make(values); }
  [[nodiscard]] std::string text() const {
    std::string out = description->name;
    for (std::size_t i = 0; i < values.size(); ++i)
      out += " " + description->parameters[i].name + " = " + values[i].to_text();
    return out;
  }
};

/// How often parameters lie at the ends of their ranges, where a problem takes seconds and is mostly refused.
enum class Extremes {
  often,   ///< one parameter in three
  seldom,  ///< one surface in thirty; one parameter in four is 10^3 or its like, though
};

/// One that hides nothing of itself; `closed`: the whole boundary of a body.
inline RandomSurface random_surface(Draw& draw, bool closed, bool plane = false,
                                    Extremes extremes = Extremes::often) {
  static const std::vector<Rational> wide{Rational(100), Rational(1, 100), Rational(1000), Rational(1, 1000)};
  static const std::vector<Rational> ordinary{Rational(1),    Rational(2),    Rational(1, 2), Rational(3),
                                              Rational(5, 2), Rational(3, 7), Rational(9, 10)};
  static const std::vector<Rational> extreme = [] {
    std::vector<Rational> found;
    for (const int n : {2, 3, 4, 5, 6, 9, 10, 11, 12, 13, 14, 15, 20, 30})
      for (const int sign : {-1, 1}) {
        Rational ten = 1;
        for (int k = 0; k < n; ++k) ten *= Rational(10);
        found.push_back(sign < 0 ? Rational(1) / ten : ten);
      }
    return found;
  }();
  while (true) {
    RandomSurface surface;
    const bool everyday = extremes == Extremes::seldom && draw.below(30) != 0;
    surface.description = &surface_catalogue()[draw.below(surface_catalogue().size())];
    if (!surface.description->unoccluded) continue;
    for (const ParameterDescription& parameter : surface.description->parameters) {
      Rational value;
      do {
        const bool ends = draw.below(everyday ? 4 : 3) == 0;
        const std::vector<Rational>& from = !ends ? ordinary : everyday ? wide : extreme;
        value = from[draw.below(from.size())];
      } while (!parameter.admits(value));
      surface.values.push_back(value);
    }
    const Surface made = surface.made();
    if (closed && !made.closed) continue;
    bool all_plane = true;
    for (const Chart& chart : made.charts) all_plane = all_plane && chart.facts().plane.has_value();
    if (plane && !all_plane) continue;
    if (!made.unoccluded) continue;
    return surface;
  }
}

}  // namespace radcert::attack
