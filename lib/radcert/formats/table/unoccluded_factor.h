// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/factors/facet_scene.h"
#include "radcert/factors/factor_matrix.h"
#include "radcert/formats/table/factor_comparison.h"

namespace radcert {

/// The factor of two rows as if nothing stood between them, for `explain`.
/// Maths     sum of the exchange areas of their triangles, as far as each lies in front of the other's plane,
///           over the area of the first
/// Requires  the scene outlives the function; units as factor_matrix
/// Result    rounded; nothing once 200,000 pairs of triangles have been looked at, in all calls together
[[nodiscard]] UnoccludedFactor unoccluded_factor(const FacetScene& scene, const FactorUnits& units);

}  // namespace radcert
