// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/polynomial/rules/degree_of_precision.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/scalar/ball.h"

namespace radcert::verification::m06 {

/// How the second half of a region of two triangles follows from the first.
enum class Halves { turned, mirrored };

/// How much a factor Phi sees of what interpolation leaves over, for monomials of one total degree.
/// Maths     max over a + b + c + d = total degree of |B(Phi, g)|, B(Phi, g) = Int Phi (I - L) g, Phi = x^a
///           y^b, g = x^c y^d; over sigma, or over the unit square, cut from (0,1) to (1,0), with x and y
///           measured from its centre and L the interpolation on each half
/// Source    [m06, (30), (31), (38)]
/// Requires  nothing; the result is meant for halves that a half turn takes to each other. Halves::mirrored
///           has the mirror image of sigma in the side x = 0 for the second half, which makes no parallelogram
/// Result    enclosed. If it is zero for all total degrees <= d, then for smooth functions on a square with
///           sides h |B| <= c h^(d+1) sum_j Int |D^j Phi| max |D^(d+1-j) g|, 0 <= j <= d - r: expand g by
///           Taylor; its part of degree i > r is seen by Phi less a polynomial of degree d - i only, which
///           the lemma of Bramble and Hilbert bounds; the rest is O(h^(d+1))
[[nodiscard]] Ball largest_defect(const TriangleBasis<Ball>& basis, Region region, int total_degree,
                                  Halves halves = Halves::turned);

}  // namespace radcert::verification::m06
