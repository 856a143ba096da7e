// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/rules/degree_of_precision.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// How far interpolation goes unseen under an integral: what decides the order of collocation at the nodes.
/// Maths     the largest d with  Int q (p - P p) = 0  for all polynomials q, p of degrees that add up to d at
///           most;  P p = sum_j p(q_j) l_j.  triangle: Int over sigma; parallelogram: over sigma and its
///           image under a half turn, each with its nodes
/// Source    the expansions in the proofs of [m06, Lemmas 5, 6, 8]: q from the kernel, p from the solution
/// Result    exact. For the space of all polynomials of degree r it is the degree of precision of the
///           interpolatory rule on the triangle, as q P p is integrated exactly wherever q p is, and that on
///           the parallelogram where products_follow; in a space of one's own P p may have a higher degree
///           than p
/// Limits    -1 where the constants are not reproduced
[[nodiscard]] int product_precision(const LagrangeFunctions& functions, Region region);

/// Whether the degrees of precision of an interpolatory rule on a triangle, d, and on the parallelogram, e,
/// are those of its products: e <= d + 1.
/// Maths     functions of degree m, all polynomials of degree r among them, m <= r + 1. Q the rule on sigma.
///           (1) d is odd: e = d. Otherwise Q is exact for degrees below d + 1 and for monomials about the
///           centre of the even degree d + 1, so of degree d + 1. (2) Int q (p - P p), q and p monomials
///           about the centre whose degrees sum to n. On the parallelogram it is 0 for odd n, and twice that
///           over sigma for even n. With deg p <= r it is 0. Else deg q P p <= n - r - 1 + m <= n, and where
///           Q is exact for q p and for q P p, Int q P p = Q(q P p) = Q(q p) = Int q p. It is on sigma for n
///           <= d, and so for even n <= d + 1, by (1) if d is odd. (3) q = 1: Int (p - P p) is what the rule
///           misses of p. So the products have d on the triangle, and on the parallelogram min(e, d + 1) at
///           least and e at most. Where e > d + 1, d is even, and P p of degree r makes q P p one of the odd
///           degree d + 1 on either triangle, which Q need not integrate: six nodes of degree 2 with d = 2, e
///           = 5 have 3 (tests/polynomial/product_precision_test.cpp)
/// Source    ours
[[nodiscard]] bool products_follow(int triangle, int parallelogram);

/// Whether products of a total degree are certainly missed, at nodes of which balls are known.
/// Maths     Int q (p - P' p) = Int q p - sum_j w_j p(q'_j) for monomials about the centre, with w_j = Int q
///           l'_j. As in at_true_nodes l = M l', so that M w = m, m_i = Int q l_i; with |M - I|_1 <= e < 1
///           |w - m|_1 <= |m|_1 e/(1 - e)
/// Requires  functions at nodes beside the true ones, balls of these in their order, e = change
/// Result    true: some product is not 0 on the triangle, for an even degree on the parallelogram too. false
///           says nothing
[[nodiscard]] bool products_certainly_missed(const LagrangeFunctions& functions,
                                             std::span<const Barycentric<Ball>> nodes, const Rational& change,
                                             int total);

}  // namespace radcert
