// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/paraboloid_cap.h"

#include <string>

#include "radcert/surface/exact_chart.h"

namespace radcert {

Surface paraboloid_cap() {
  Surface surface;
  surface.name = "paraboloid_cap";
  surface.charts = disk_charts("floor", 1, 0, Facing::up);
  const ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 0}, .linear = {{0, 0, 1}, -1}},
                                 .revolution = z_axis()};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points upwards
    surface.charts.push_back(make_exact_chart<ParaboloidQuadrant>(
        {.name = "cap/" + quadrant.name(),
         .piece = "cap",
         .domain = ChartDomain::unit_triangle,
         .orientation = quadrant.is_right_handed() ? Orientation::against_the_cross_product
                                                   : Orientation::along_the_cross_product,
         .structure = structure},
        quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

}  // namespace radcert
