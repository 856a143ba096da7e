// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/transport/edge_closure.h"
#include "radcert/continuous/transport/smoothness.h"

namespace radcert {

/// Functions q_k on a mesh, whatever they are, and what is known of their residuals t_k = T w_k - q_k.
/// Maths     w_k = E_k + rho q_k, rounded: each coefficient within 2 u of those of |E_k| + rho |q_k|;  rho
///           constant on panels, E_k polynomials on elements of the degree of q
/// Requires  the scene and the reflectivity outlive it; E and q have the same degree and count
struct Trial {
  Trial(const SectorScene& on, const std::vector<double>& rho_by_panel, std::vector<SectorElement> mesh,
        const SectorFunctions& emissions, SectorFunctions functions);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  Trial(Trial&&) = delete;
  Trial& operator=(Trial&&) = delete;
  ~Trial() = default;

  const SectorScene& scene;
  const std::vector<double>& reflectivity;  ///< by panel
  std::vector<SectorElement> elements;
  SectorFunctions q;
  SectorFunctions w;
  EdgeClosure closure;
  Smoothness smoothness;
  Penumbra penumbra;

  [[nodiscard]] const Sector& sector(std::size_t element) const {
    return scene.sectors()[elements[element].sector];
  }
  [[nodiscard]] double rho(std::size_t element) const { return reflectivity[sector(element).panel]; }
};

}  // namespace radcert
