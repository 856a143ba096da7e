// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/scalar/ball.h"
#include "radcert/visibility/point_view.h"

namespace radcert {

/// The radiosity kernel integrated over what a point sees of a triangle.
/// Maths     Int G(P,Q) V(P,Q) dS_Q over the triangle = 1/2 sum_k Gamma_k (n_P . m_k), over the sides of all
///           parts: Gamma_k the angle under which P sees side k, m_k the unit normal of its plane into the
///           part, n_P = normal / |normal|; without 1/pi
/// Source    Lambert, Photometria, 1760: the flux of a polygon
/// Requires  the scene, viewpoint and triangle that the region was made of
/// Result    an enclosure at the current precision; exactly 0 where nothing is seen
/// Limits    a triangle that is not cut by the horizon counts with the sign of G, also where rounding of P
///           has put it behind
[[nodiscard]] Ball solid_configuration(const Scene& scene, const Viewpoint& from, std::size_t triangle,
                                       const VisibleRegion& region);

/// The same in doubles.
/// Maths     as solid_configuration
/// Source    directions in doubles of 64 bits' mantissa where a bound of their error allows it, else from
///           whole numbers
/// Requires  as solid_configuration
/// Result    each direction is right to 2^-52, so that the result is within about 1e-15 a side, however thin
///           a part is
/// Limits    no bound is returned
[[nodiscard]] double solid_configuration_in_double(const Scene& scene, const Viewpoint& from,
                                                   std::size_t triangle, const VisibleRegion& region);

}  // namespace radcert
