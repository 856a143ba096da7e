// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/trial.h"

#include <utility>

#include "radcert/continuous/trial_functions.h"

namespace radcert {

Trial::Trial(const SectorScene& on, const std::vector<double>& rho_by_panel, std::vector<SectorElement> mesh,
             const SectorFunctions& emissions, SectorFunctions functions)
    : scene(on),
      reflectivity(rho_by_panel),
      elements(std::move(mesh)),
      q(std::move(functions)),
      w(densities(scene, elements, reflectivity, emissions, q)),
      closure(scene, elements, w),
      smoothness(scene, elements, w, q, closure),
      penumbra(scene, elements, w) {}

}  // namespace radcert
