// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/geometry/mesh_repair.h"
#include "radcert/hypotheses/front.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/surface.h"

namespace radcert::app {

/// The surface of the catalogue with this name; InputError with the nearest name where there is none.
const SurfaceDescription& surface_named(const std::string& name);

/// It, with the default values of its parameters.

/// The repairs of these words; InputError for any other.
MeshRepair repair_of(const std::vector<std::string>& words);

/// The rule of this word; InputError for any other.
FrontRule front_of(const std::string& word);

/// What help says of --unit.
inline const std::string unit_help =
    "The unit of the coordinates, which areas carry: mm, cm, m, in; nothing is converted";

/// What help says of --front.
inline const std::string front_help =
    "Where light travels from a triangle of a mesh: right-hand, from where its corners run counterclockwise, "
    "left-hand, or auto: inside of closed scenes, right-hand in open ones; default auto";

}  // namespace radcert::app
