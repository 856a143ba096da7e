// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/paraboloid_cap.h"

#include "radcert/surface/catalogue.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Surface paraboloid_cap() {
  Surface surface;
  surface.name = "paraboloid_cap";
  surface.charts = disk_charts("floor", 1, 0, Facing::up);
  const ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 0}, .linear = {{0, 0, 1}, -1}}};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points upwards
    surface.charts.push_back(make_exact_chart<ParaboloidQuadrant>(
        quadrant_facts("cap", quadrant, ChartDomain::unit_triangle, Facing::down, structure), quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

SurfaceDescription paraboloid_cap_entry() {
  return {.name = "paraboloid_cap",
          .summary = "the boundary of 0 <= z <= 1 - x^2 - y^2, four charts a piece",
          .parameters = {},
          .pieces = {"floor", "cap"},
          .build = [](std::span<const Rational>) { return paraboloid_cap(); }};
}

}  // namespace radcert
