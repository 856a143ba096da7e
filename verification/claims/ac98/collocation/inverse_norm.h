// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::verification::ac98 {

/// How large the collocation matrix and the inverse of I less it are, for linear interpolation.
/// Maths     matrix = max_i sum_j |k_ij|,  inverse = max_i sum_j |[(I - K_n)^-1]_ij|
/// Source    [ac98, (40)]; the columns of the inverse are solutions for unit vectors
/// Requires  an unoccluded surface and a triangulation of it; a reflectivity that is a double
/// Result    enclosed for all matrices within the radii of the entries; failed balls where these are not
///           enclosed or not proved regular
/// Limits    dense: as many systems as nodes
struct CollocationNorms {
  Ball matrix;
  Ball inverse;
};
[[nodiscard]] CollocationNorms collocation_norms(const Surface& surface, const Triangulation& triangulation,
                                                 const Rational& alpha, double reflectivity);

}  // namespace radcert::verification::ac98
