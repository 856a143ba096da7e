// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "radcert/core/work_limit.h"

namespace radcert {

/// Layers of graded_elements up to which a search goes, one after the other.
extern const WorkLimit most_layers;

/// How far a search for an enclosure has come.
struct EnclosureProgress {
  int layers = 0;
  int degree = 0;
  std::size_t elements = 0;
  std::size_t unknowns = 0;
  double mesh_size = 0;     ///< the largest diameter of an element
  std::size_t samples = 0;  ///< points at which residuals were taken, in all
  double width = 0;         ///< of the widest enclosure
  double residual = 0;      ///< a bound of (Int rho t^2)^(1/2), where duality uses it
};

using EnclosureListener = std::function<void(const EnclosureProgress&)>;

}  // namespace radcert
