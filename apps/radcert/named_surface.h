// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/geometry/mesh_repair.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/surface.h"

namespace radcert::app {

/// The surface of the catalogue with this name; InputError with the nearest name where there is none.
const SurfaceDescription& surface_named(const std::string& name);

/// It, with the default values of its parameters.

/// The repairs of these words; InputError for any other.
MeshRepair repair_of(const std::vector<std::string>& words);

}  // namespace radcert::app
