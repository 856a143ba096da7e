// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/two_piece.h"

#include <utility>

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

}  // namespace radcert
