// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/section_7/sites_on_scene.h"

#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"

namespace radcert::verification::psg10 {

const Surface& paper_scene() {
  static const Surface surface = sphere_over_disk_surface();
  return surface;
}

SiteSet sites_on_scene(std::uint64_t seed, double separation) {
  return poisson_disk_sites(paper_scene(), {.separation = separation, .seed = seed}).value();
}

RadialBasis basis_on(const SiteSet& sites, RadialBasisChoice choice) {
  choice.radius.too_few = TooFewNeighbours::farthest;
  return RadialBasis::make(sites, choice).value();
}

}  // namespace radcert::verification::psg10
