// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/octahedron.h"

#include <string>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/triangle.h"

namespace radcert {

Surface octahedron() {
  Surface surface;
  surface.name = "octahedron";
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1}) {
        std::string name = "face_";
        for (const int sign : {x, y, z}) name += sign > 0 ? 'p' : 'm';
        surface.charts.push_back(
            make_triangle({.name = name, .piece = name}, {x, 0, 0}, {0, y, 0}, {0, 0, z}, {0, 0, 0}));
        surface.diagonals.push_back(Diagonal::main);
      }
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

SurfaceDescription octahedron_entry() {
  return {.name = "octahedron",
          .summary = "the boundary of |x| + |y| + |z| <= 1",
          .parameters = {},
          .pieces = {"face_ppp", "face_mpp", "face_pmp", "face_mmp", "face_ppm", "face_mpm", "face_pmm",
                     "face_mmm"},
          .build = [](std::span<const Rational>) { return octahedron(); }};
}

}  // namespace radcert
