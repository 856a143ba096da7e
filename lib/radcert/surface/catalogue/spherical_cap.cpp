// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/spherical_cap.h"

#include "radcert/surface/catalogue_parameters.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Surface spherical_cap(const Rational& fraction) {
  expects(fraction > Rational(0) && fraction < Rational(1), "0 < fraction < 1", named("fraction", fraction));
  Surface surface;
  surface.name = "spherical_cap";
  surface.parameters = {{"fraction", fraction}};
  const ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 1}, .linear = {{0, 0, 0}, -1}}};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points outwards
    surface.charts.push_back(make_exact_chart<SphericalCapQuadrant>(
        quadrant_facts("cap", quadrant, ChartDomain::unit_triangle, Facing::down, structure), fraction,
        quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  return surface;
}

SurfaceDescription spherical_cap_entry() {
  return {.name = "spherical_cap",
          .summary = "the cap of the unit sphere with a given part of its area, open at its rim, four charts",
          .parameters = {inner_part("fraction", "1/4", "the part of the sphere's area")},
          .pieces = {"cap"},
          .build = [](std::span<const Rational> v) { return spherical_cap(v[0]); }};
}

}  // namespace radcert
