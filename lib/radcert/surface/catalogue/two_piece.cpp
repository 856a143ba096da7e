// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/two_piece.h"

#include <utility>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Surface two_piece(const Rational& p) {
  expects(p >= Rational(1), "p >= 1", named("p", p));
  Surface surface;
  surface.name = "two_piece";
  surface.parameters = {{"p", p}};
  surface.charts.push_back(
      make_rectangle({.name = "lower", .piece = "lower", .orientation = Orientation::along_the_cross_product},
                     {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  ChartFacts roof{.name = "upper", .piece = "upper", .orientation = Orientation::against_the_cross_product};
  if (p == Rational(1)) {
    surface.charts.push_back(make_rectangle(std::move(roof), {0, 0, 2}, {1, 0, -1}, {0, 1, 0}));
  } else {
    roof.structure.ruling = Vector<Rational>{0, 1, 0};
    roof.singular = p.is_integer() ? SingularLine::none : SingularLine::s_zero;
    surface.charts.push_back(make_exact_chart<PowerRoof>(std::move(roof), p));
  }
  surface.diagonals.assign(2, Diagonal::main);
  return surface;
}

SurfaceDescription two_piece_entry() {
  // Beyond it the roof falls within a layer at x = 1 that no rule of the coarse triangulation would see.
  constexpr long largest_power = 1000;
  return {.name = "two_piece",
          .summary = "the unit square below the roof z = 2 - x^p [ac98, (94)]",
          .parameters = {{.name = "p",
                          .requirement = "a number in [1, 1000]",
                          .default_text = "2",
                          .admits = [](const Rational& p) { return p >= 1 && p <= largest_power; },
                          .meaning = "the power of x in the roof"}},
          .pieces = {"lower", "upper"},
          .build = [](std::span<const Rational> v) { return two_piece(v[0]); }};
}

}  // namespace radcert
