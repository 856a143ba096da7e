// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/trial.h"

#include <algorithm>
#include <utility>

#include "radcert/continuous/trial_functions.h"

namespace radcert {
namespace {

double rounding_of(const ElementReflectivity& rho, const SectorFunctions& emissions, const SectorFunctions& q,
                   std::size_t elements) {
  double most = 0;
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t k = 0; k < q.count(); ++k)
      most = std::max(most, rho.rounding(e, emissions.of(e, k), q.of(e, k)));
  return most;
}

}  // namespace

Trial::Trial(const SectorScene& on, const Reflectivity& rho, std::vector<SectorElement> mesh,
             const SectorFunctions& emissions, SectorFunctions functions, double of_emissions)
    : scene(on),
      elements(std::move(mesh)),
      reflectivity(rho, scene, elements),
      q(std::move(functions)),
      w(densities(reflectivity, emissions, q)),
      rounding((rounding_of(reflectivity, emissions, q, elements.size()) + of_emissions) * upward),
      closure(scene, elements, w),
      smoothness(scene, elements, w, q, closure),
      penumbra(scene, elements, w) {}

}  // namespace radcert
