// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/two_squares.h"

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert {

Surface two_squares() {
  const Vector<Rational> origin{0, 0, 0};
  const Vector<Rational> x{1, 0, 0};
  const Vector<Rational> y{0, 1, 0};
  const Vector<Rational> z{0, 0, 1};
  Surface surface;
  surface.name = "two_squares";
  surface.charts.push_back(make_rectangle(
      {.name = "xz", .piece = "xz", .orientation = Orientation::against_the_cross_product}, origin, x, z));
  surface.charts.push_back(make_rectangle(
      {.name = "xy", .piece = "xy", .orientation = Orientation::along_the_cross_product}, origin, x, y));
  surface.diagonals.assign(2, Diagonal::main);
  surface.pieces_meet_at_angle = true;
  return surface;
}

SurfaceDescription two_squares_entry() {
  return {.name = "two_squares",
          .summary = "two unit squares at a right angle along an edge [ac98, (20)]",
          .parameters = {},
          .pieces = {"xz", "xy"},
          .build = [](std::span<const Rational>) { return two_squares(); }};
}

}  // namespace radcert
