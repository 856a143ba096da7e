// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/surface/catalogue.h"

namespace radcert::sample {

/// The whole catalogue, with its default parameters.
inline std::vector<Surface> default_surfaces() {
  std::vector<Surface> all;
  for (const SurfaceDescription& entry : surface_catalogue()) all.push_back(default_surface(entry));
  return all;
}

}  // namespace radcert::sample
