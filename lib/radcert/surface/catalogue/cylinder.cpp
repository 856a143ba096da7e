// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/cylinder.h"

#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue_parameters.h"

namespace radcert {

Surface cylinder(const Rational& radius, const Rational& height) {
  Surface surface = cone(radius, radius, height);
  surface.name = "cylinder";
  surface.parameters = {{"radius", radius}, {"height", height}};
  return surface;
}

SurfaceDescription cylinder_entry() {
  return {.name = "cylinder",
          .summary = "the boundary of a circular cylinder, four charts a piece",
          .parameters = {positive_length("radius", "1", "the radius of both ends"),
                         positive_length("height", "2", "the distance of the ends")},
          .pieces = {"floor", "ceiling", "mantle"},
          .build = [](std::span<const Rational> v) { return cylinder(v[0], v[1]); }};
}

}  // namespace radcert
