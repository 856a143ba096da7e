// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/rules/degree_of_precision.h"

namespace radcert {

/// How far interpolation goes unseen under an integral: what decides the order of collocation at the nodes.
/// Maths     the largest d with  Int q (p - P p) = 0  for all polynomials q, p of degrees that add up to d at
///           most;  P p = sum_j p(q_j) l_j.  triangle: Int over sigma; parallelogram: over sigma and its
///           image under a half turn, each with its nodes
/// Source    the expansions in the proofs of [m06, Lemmas 5, 6, 8]: q from the kernel, p from the solution
/// Result    exact. For the space of all polynomials of degree r this is the degree of precision of the
///           interpolatory rule, as q P p is then integrated exactly wherever q p is; in a space of one's own
///           P p may have a higher degree than p
/// Limits    -1 where the constants are not reproduced
[[nodiscard]] int product_precision(const LagrangeFunctions& functions, Region region);

}  // namespace radcert
