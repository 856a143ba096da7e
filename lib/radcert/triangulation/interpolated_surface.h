// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A surface put together from the interpolants of another one's elements, and its triangulation.
struct InterpolatedSurface {
  Surface surface;
  Triangulation triangulation;  ///< element k is that of the other surface's element k
};

/// The interpolant of a triangulated surface.
/// Maths     S~_n = union of the m~_k(sigma), m~_k of degree r on the evenly spaced lattice of sigma
/// Source    [ac98, section 4.1]
/// Requires  1 <= degree <= 6, else ContractViolation; triangles that belong to the surface
/// Result    one chart for each element of a curved chart, whose triangle is the whole unit triangle with the
///           vertices in the element's order; an affine chart is its own interpolant, and is kept with its
///           elements. m~_k and m_k take the same barycentric coordinates. Pieces, parameters and facts are
///           those of the surface, but charts_join_smoothly
/// Limits    `unoccluded` is taken over, V = 1 as in [ac98, (91)], though S~_n need not be convex; `closed`
///           holds up to rounding along the sides. Where the surface's own triangulation is graded or cut
///           otherwise, so is the interpolant
InterpolatedSurface interpolate(const Surface& surface, const Triangulation& triangulation, int degree);

}  // namespace radcert
