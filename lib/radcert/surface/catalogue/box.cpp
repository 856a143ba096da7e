// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/box.h"

#include <array>

#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue_parameters.h"

namespace radcert {

Surface box(const Rational& a, const Rational& b, const Rational& c) {
  expects(a > Rational(0) && b > Rational(0) && c > Rational(0), "a, b, c > 0", named("a", a), named("b", b),
          named("c", c));
  const std::array<Vector<Rational>, 3> sides{{{a, 0, 0}, {0, b, 0}, {0, 0, c}}};
  const std::array<std::array<const char*, 2>, 3> names{
      {{"west", "east"}, {"south", "north"}, {"floor", "ceiling"}}};
  const Rational half(1, 2);
  Surface surface;
  surface.name = "box";
  surface.parameters = {{"a", a}, {"b", b}, {"c", c}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vector<Rational>& first = sides[(axis + 1) % 3];
    const Vector<Rational>& second = sides[(axis + 2) % 3];
    const std::array<Vector<Rational>, 2> origins{Vector<Rational>{0, 0, 0}, sides[axis]};
    for (std::size_t end = 0; end < 2; ++end) {
      const bool near_origin = end == 0;
      surface.charts.push_back(make_rectangle({.name = names[axis][end], .piece = names[axis][end]},
                                              origins[end], first, second, {half * a, half * b, half * c}));
      surface.diagonals.push_back(near_origin ? Diagonal::anti : Diagonal::main);
    }
  }
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

Surface cube() {
  Surface surface = box(1, 1, 1);
  surface.name = "cube";
  surface.parameters.clear();
  return surface;
}

SurfaceDescription box_entry() {
  return {.name = "box",
          .summary = "the boundary of [0,a] x [0,b] x [0,c] [ac98, section 2.2]",
          .parameters = {positive_length("a", "1", "the edge along x"),
                         positive_length("b", "2", "the edge along y"),
                         positive_length("c", "5", "the edge along z")},
          .pieces = {"west", "east", "south", "north", "floor", "ceiling"},
          .build = [](std::span<const Rational> v) { return box(v[0], v[1], v[2]); }};
}

}  // namespace radcert
