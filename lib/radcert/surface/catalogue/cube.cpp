// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"

namespace radcert {

SurfaceDescription cube_entry() {
  return {.name = "cube",
          .summary = "the boundary of the unit cube [ac98, section 5]",
          .parameters = {},
          .pieces = {"west", "east", "south", "north", "floor", "ceiling"},
          .build = [](std::span<const Rational>) { return cube(); }};
}

}  // namespace radcert
