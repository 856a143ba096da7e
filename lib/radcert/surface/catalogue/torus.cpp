// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/torus.h"

#include <string>

#include "radcert/surface/catalogue_parameters.h"

namespace radcert {

Surface torus(const Rational& radius, const Rational& ratio) {
  expects(radius > Rational(0) && ratio > Rational(0) && ratio < Rational(1), "radius > 0, 0 < ratio < 1",
          named("radius", radius), named("ratio", ratio));
  Surface surface;
  surface.name = "torus";
  surface.parameters = {{"radius", radius}, {"ratio", ratio}};
  for (const Quadrant& around : quadrants())
    for (const Quadrant& of_tube : quadrants()) {
      const bool outwards = around.is_right_handed() == of_tube.is_right_handed();  // D_s F x D_t F
      surface.charts.push_back(
          make_chart<TorusPatch>({.name = "patch_" + around.name() + "_" + of_tube.name(),
                                  .piece = "torus",
                                  .orientation = outwards ? Orientation::against_the_cross_product
                                                          : Orientation::along_the_cross_product,
                                  .structure = {.revolution = z_axis()}},
                                 radius, ratio, around, of_tube));
    }
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.unoccluded = false;
  return surface;
}

SurfaceDescription torus_entry() {
  return {
      .name = "torus",
      .summary = "the torus of that radius, its tube ratio times as wide; parts hide others: not for solve",
      .parameters = {positive_length("radius", "1", "the radius of the circle about which the tube runs"),
                     inner_part("ratio", "1/2", "the tube's radius as a part of the other")},
      .pieces = {"torus"},
      .build = [](std::span<const Rational> v) { return torus(v[0], v[1]); },
      .unoccluded = false};
}

}  // namespace radcert
