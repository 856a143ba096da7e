// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/work_limit.h"
#include "radcert/factors/facet_scene.h"
#include "radcert/scalar/ball.h"

namespace radcert {

extern const WorkLimit most_evaluations_of_a_shadow;

/// The work allowed for a guaranteed exchange area.
struct CertifiedDemand {
  double radius = 1e-10;                                   ///< wanted, relative to the receiver's area
  long work_limit = most_evaluations_of_a_shadow.value();  ///< for each shadow, or pieces of edges in all
};

/// The direct exchange area of two triangles between which others may stand, enclosed.
/// Maths     contour_exchange_area; where source and occluders stand on the planes of both triangles, A_1
///           F_12 = E - sum over the occluders of B_O, where E is that without occluders and B_O what
///           occluder O keeps back, in case no segment between the triangles meets two of them: they lie in
///           one plane, or are those faces of one convex body that look at the receiver. In general, by
///           solids k: E - sum_k B_k <= A_1 F_12 <= E - max_k B_k; and if no segment meets solids of two
///           groups, A_1 F_12 is E less what each group keeps back
/// Source    E: polygon_to_polygon. Past occluders: contour_exchange_area, B_O: shadow_exchange_area
/// Requires  triangles of this scene, and their pair
/// Result    an enclosure at the current precision, always; a shadow that is not enclosed within the work
///           limit counts with what was reached, and then with [0, E]
/// Limits    of shadows of a group that meet at sides in both planes, what the smaller ones keep back is not
///           known: wide
[[nodiscard]] Ball certified_exchange_area(const FacetScene& scene, std::size_t first, std::size_t second,
                                           const FacetPair& pair, const CertifiedDemand& demand);

/// The area of a triangle, enclosed.
/// Result    in the scene's coordinates, times the square of its unit
[[nodiscard]] Ball certified_area(const FacetScene& scene, std::size_t triangle);

}  // namespace radcert
