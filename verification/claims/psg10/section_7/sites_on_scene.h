// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "radcert/meshless/radial_basis.h"
#include "radcert/surface/surface.h"

namespace radcert::verification::psg10 {

/// The separation of the sites of [psg10, figure 9].
inline constexpr double paper_separation = 3;

/// The surface of section VIII, made once.
[[nodiscard]] const Surface& paper_scene();
/// As many sites of a separation as find room on it.
[[nodiscard]] SiteSet sites_on_scene(std::uint64_t seed, double separation = paper_separation);
/// A basis on sites. Where a site has too few others at a finite distance, the farthest of them.
[[nodiscard]] RadialBasis basis_on(const SiteSet& sites, RadialBasisChoice choice);

}  // namespace radcert::verification::psg10
