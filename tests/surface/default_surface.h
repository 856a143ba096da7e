// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/surface/catalogue.h"

namespace radcert::sample {

/// An entry of the catalogue with its default parameters.
inline Surface default_surface(const SurfaceDescription& entry) {
  std::vector<Rational> values;
  for (const ParameterDescription& parameter : entry.parameters)
    values.push_back(Rational::parse(parameter.default_text).value());
  return entry.make(values);
}

/// The whole catalogue, likewise.
inline std::vector<Surface> default_surfaces() {
  std::vector<Surface> all;
  for (const SurfaceDescription& entry : surface_catalogue()) all.push_back(default_surface(entry));
  return all;
}

}  // namespace radcert::sample
