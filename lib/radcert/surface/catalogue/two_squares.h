// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// Two unit squares that meet at a right angle along an edge.
/// Maths     S_xz = {(x,0,z)}, S_xy = {(x,y,0)}, 0 <= x, y, z <= 1; inner normals +y and +z
/// Source    [ac98, (20)]
/// Requires  -
/// Result    pieces `xz` and `xy`
/// Limits    not closed
inline Surface two_squares() {
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

}  // namespace radcert
