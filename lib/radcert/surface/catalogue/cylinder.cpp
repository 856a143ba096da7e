// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/cylinder.h"

#include "radcert/surface/catalogue/cone.h"

namespace radcert {

Surface cylinder(const Rational& radius, const Rational& height) {
  Surface surface = cone(radius, radius, height);
  surface.name = "cylinder";
  surface.parameters = {{"radius", radius}, {"height", height}};
  return surface;
}

}  // namespace radcert
