// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/disk.h"

#include <utility>

#include "radcert/surface/exact_chart.h"

namespace radcert {

ChartFacts quadrant_facts(const std::string& piece, const Quadrant& quadrant, ChartDomain domain,
                          Facing facing, ChartStructure structure) {
  structure.revolution = z_axis();
  return {.name = piece + "/" + quadrant.name(),
          .piece = piece,
          .domain = domain,
          .orientation = quadrant.is_right_handed() == (facing == Facing::up)
                             ? Orientation::along_the_cross_product
                             : Orientation::against_the_cross_product,
          .structure = std::move(structure)};
}

std::vector<Chart> disk_charts(const std::string& piece, const Rational& radius, const Rational& height,
                               Facing facing) {
  std::vector<Chart> charts;
  for (const Quadrant& quadrant : quadrants()) {
    ChartFacts facts = quadrant_facts(piece, quadrant, ChartDomain::unit_triangle, facing);
    facts.plane_of_disk = Plane({0, 0, height}, {1, 0, 0}, {0, 1, 0});
    charts.push_back(make_exact_chart<DiskQuadrant>(std::move(facts), radius, height, quadrant));
  }
  return charts;
}

}  // namespace radcert
