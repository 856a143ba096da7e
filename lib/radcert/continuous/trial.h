// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/reflectivity.h"
#include "radcert/continuous/transport/edge_closure.h"
#include "radcert/continuous/transport/smoothness.h"

namespace radcert {

/// Functions q_k on a mesh, whatever they are, and what is known of their residuals t_k = T w_k - q_k.
/// Maths     w_k is E_k + rho q_k within `rounding`, for the exact E_k and rho: E_k polynomials on elements,
///           whose coefficients are given to the nearest, or which are within `of_emissions` of those given
/// Requires  the scene outlives it; E and q have the same count, and E the degree of q and that of rho
///           together
struct Trial {
  Trial(const SectorScene& on, const Reflectivity& rho, std::vector<SectorElement> mesh,
        const SectorFunctions& emissions, SectorFunctions functions, double of_emissions = 0);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  Trial(Trial&&) = delete;
  Trial& operator=(Trial&&) = delete;
  ~Trial() = default;

  const SectorScene& scene;
  std::vector<SectorElement> elements;
  ElementReflectivity reflectivity;
  SectorFunctions q;
  SectorFunctions w;
  double rounding = 0;  ///< of all w_k in the maximum norm
  EdgeClosure closure;
  Smoothness smoothness;
  Penumbra penumbra;

  [[nodiscard]] const Sector& sector(std::size_t element) const {
    return scene.sectors()[elements[element].sector];
  }
  /// At least sup rho on an element, up to one rounding.
  [[nodiscard]] double rho(std::size_t element) const { return reflectivity.largest(element); }
};

}  // namespace radcert
