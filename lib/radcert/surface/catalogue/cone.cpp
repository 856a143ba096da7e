// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/cone.h"

#include <utility>

#include "radcert/surface/catalogue_parameters.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Surface cone(const Rational& radius, const Rational& top, const Rational& height) {
  expects(radius > Rational(0) && top > Rational(0) && height > Rational(0), "radius, top, height > 0",
          named("radius", radius), named("top", top), named("height", height));
  Surface surface;
  surface.name = "cone";
  surface.parameters = {{"radius", radius}, {"top", top}, {"height", height}};
  surface.charts = disk_charts("floor", radius, 0, Facing::up);
  for (Chart& chart : disk_charts("ceiling", top, height, Facing::down))
    surface.charts.push_back(std::move(chart));
  const Rational growth = (top - radius) / height;
  ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 0},
                                              .linear = {{0, 0, 0}, 0},
                                              .nappe = AffineForm{{0, 0, growth}, radius}}};
  if (top == radius) structure.ruling = Vector<Rational>{0, 0, height};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points outwards
    surface.charts.push_back(make_exact_chart<ConeMantle>(
        quadrant_facts("mantle", quadrant, ChartDomain::unit_square, Facing::down, structure), radius, top,
        height, quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

SurfaceDescription cone_entry() {
  return {.name = "cone",
          .summary = "the boundary of a truncated cone, four charts a piece",
          .parameters = {positive_length("radius", "1", "the radius of the lower end"),
                         positive_length("top", "1/2", "the radius of the upper end"),
                         positive_length("height", "1", "the distance of the ends")},
          .pieces = {"floor", "ceiling", "mantle"},
          .build = [](std::span<const Rational> v) { return cone(v[0], v[1], v[2]); }};
}

}  // namespace radcert
