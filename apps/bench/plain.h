// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/matrix.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::bench {

/// The collocation matrix by a plain program: what every figure is compared with.
/// Maths     entries(i, k p + j) = 1/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q; a triangle is cut into four until
///           it is far from v_i in terms of its size, then 10 x 10 Gauss points
/// Source    [ac98, (40)]
/// Requires  a surface whose charts are analytic, no node where two pieces meet at an angle
/// Result    entries to about 1e-11 of the row; unoptimised on purpose: doubles one at a time, one thread,
///           nothing kept
/// Limits    shares charts, basis functions and Gauss points with the library, and none of its quadrature
Matrix<double> plain_collocation_matrix(const Surface& surface, const Triangulation& triangulation,
                                        const InsetBasis<double>& basis);

}  // namespace radcert::bench
