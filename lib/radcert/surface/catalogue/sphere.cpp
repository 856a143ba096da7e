// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {

SurfaceDescription sphere_entry() {
  return {.name = "sphere",
          .summary = "the unit sphere, eight charts",
          .parameters = {},
          .pieces = {"sphere"},
          .build = [](std::span<const Rational>) { return sphere(); }};
}

}  // namespace radcert
