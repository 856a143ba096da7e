// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/tetrahedron.h"

#include <array>
#include <string>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/triangle.h"

namespace radcert {

Surface tetrahedron() {
  const std::array<Vector<Rational>, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  Surface surface;
  surface.name = "tetrahedron";
  for (std::size_t opposite = 0; opposite < corners.size(); ++opposite) {
    std::string name = "face_";
    for (const Rational& x : {corners[opposite].x, corners[opposite].y, corners[opposite].z})
      name += x.sign() < 0 ? 'p' : 'm';
    const auto corner = [&](std::size_t i) { return corners[(opposite + i) % corners.size()]; };
    surface.charts.push_back(
        make_triangle({.name = name, .piece = name}, corner(1), corner(2), corner(3), {0, 0, 0}));
    surface.diagonals.push_back(Diagonal::main);
  }
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

SurfaceDescription tetrahedron_entry() {
  return {.name = "tetrahedron",
          .summary = "the boundary of the regular tetrahedron with corners in four of those of [-1,1]^3",
          .parameters = {},
          .pieces = {"face_mmm", "face_mpp", "face_pmp", "face_ppm"},
          .build = [](std::span<const Rational>) { return tetrahedron(); }};
}

}  // namespace radcert
