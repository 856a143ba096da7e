// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/rules/degree_of_precision.h"

namespace radcert {

/// How a degree of precision is known.
enum class PrecisionProof {
  exact,        ///< in rational arithmetic, for the nodes as they are given
  algebraic,    ///< for the algebraic nodes that the given ones approximate: exactly, as zeros of polynomials
  certificate,  ///< for the nodes that Krawczyk's test proves beside the given ones
};

/// The degrees of product_precision, which orders of convergence follow.
struct ProductPrecision {
  int triangle = -1;
  int parallelogram = -1;
};

/// The facts of interpolation at nodes on a triangle.
/// Maths     w_j = Int l_j;  determinant det (B_k(q_j)), or det (f_m(q_j)) in a space of one's own;  norm of
///           P_n: max sum_j |l_j|; condition: max_k sum_j |c_kj|, the norm of the values' map to Bernstein
///           coefficients; for all polynomials of a degree that is (B_k(q_j))^-1, whose inverse has the norm
///           1 where the nodes lie in the triangle
/// Source    [m06, (13)-(17)], [ac98, (37), (53)-(55)]
/// Requires  made by basis_facts
/// Result    proof = exact: weights, determinant and condition exact, norm enclosed. Otherwise nodes, weights
///           and determinant are those of nodes beside the true ones, signs of weights are as `proof` says,
///           and norm and condition hold for the true nodes, the condition from above: see at_true_nodes.
///           Precision as `proof` says. norm <= condition
struct BasisFacts {
  int degree = 0;      ///< of the functions
  int reproduced = 0;  ///< all polynomials of this degree are among them
  std::vector<Barycentric<Rational>> nodes;
  std::vector<Rational> weights;
  Rational determinant;
  Rational condition;
  LebesgueConstant norm;
  EnclosedPrecision triangle;
  EnclosedPrecision parallelogram;
  PrecisionProof proof = PrecisionProof::exact;
  std::optional<ProductPrecision> products = {};  ///< of a space of one's own, and where not
                                                  ///< products_follow; else degrees of the rule
};

/// The degrees of product_precision, for any basis.
/// Requires  products, or degrees of the rule that products_follow, else ContractViolation
[[nodiscard]] ProductPrecision product_precision(const BasisFacts& facts);

/// The facts of nodes that a certificate is about, from those at nodes beside them.
/// Maths     at_true_nodes; precision as the certificate has it. Products, with m the degree of the space and
///           r that up to which it has all polynomials, m <= r + 1: where products_follow, the degrees of the
///           rule; else, with d that on the triangle, d + 1 on the parallelogram if products of degree d + 2
///           are certainly missed
/// Requires  facts of these functions; a certificate of their nodes, with their space if they have one
/// Result    proof: certificate; a reason where at_true_nodes has one, for a space with m > r + 1, and where
///           products are not decided
[[nodiscard]] Outcome<BasisFacts> certified_facts(BasisFacts facts, const LagrangeFunctions& functions,
                                                  const SymmetricCertificate& certificate);

/// Everything about nodes, in exact arithmetic.
/// Maths     see BasisFacts
/// Requires  tolerance > 0 for the norm, else ContractViolation
/// Result    proof: exact
/// Limits    as lebesgue_constant
[[nodiscard]] BasisFacts basis_facts(const LagrangeFunctions& functions, const Rational& tolerance);

/// Facts at nodes of which balls are known, from those at nodes beside them.
/// Maths     l_i the functions of the nodes beside, l'_j those of the true nodes q'_j, M_ij = l_i(q'_j), e =
///           max_j sum_i |M_ij - delta_ij|. Where e < 1 M has an inverse, so that the true nodes are
///           unisolvent, l = M l', and as |M|_1 <= 1 + e, |M^-1|_1 <= 1/(1 - e),
///               norm/(1 + e) <= norm' <= norm/(1 - e), and the same for the condition
/// Requires  facts of these functions; as many balls as nodes, in their order, else ContractViolation
/// Result    norm enclosed and condition bounded from above for all nodes in the balls; a reason where e <
///           1/2 is not certain
/// Limits    the other facts are handed on
[[nodiscard]] Outcome<BasisFacts> at_true_nodes(BasisFacts facts, const LagrangeFunctions& functions,
                                                std::span<const Barycentric<Ball>> nodes);

/// The degree of precision at the inset alpha_0 of a degree.
/// Maths     the defects there: rational functions of alpha at a zero of the condition
/// Source    [m06, Theorem 7]
/// Requires  superconvergent_inset(degree) exists, else ContractViolation
/// Result    degree exact; the defect enclosed at the current precision of balls
[[nodiscard]] EnclosedPrecision precision_at_superconvergent_inset(int degree, Region region);

/// The orders of convergence that theory predicts for collocation with a basis.
/// Maths     everywhere r + 1, r the degree that is reproduced. At the nodes, with d the precision (see
///           product_precision) on the parallelogram and d' on the triangle: far elements in pairs give
///           h^(d+1) Int |v - Q|^(r-d) dS, which is h^(d+1) for d < r + 2, h^(r+3) |log h| for d = r + 2,
///           h^(r+3) beyond; the O(1/h) unpaired ones h^(d'+2); the element with the node itself h^(r+3), as
///           G has no continuous value there
/// Source    [m06, Theorems 4, 7, 9 and their proofs]
/// Result    curved: a smooth surface, symmetric triangulation; smooth_kernel: where G is smooth at P = Q as
///           well (a sphere) and between distinct pieces; at_edges: the largest error over all nodes where
///           pieces meet at an angle
/// Limits    upper bounds of the error have these orders for smooth data; at_edges is no more than the order
///           everywhere
struct PredictedOrders {
  int everywhere = 0;
  int curved = 0;
  bool curved_has_logarithm = false;
  int smooth_kernel = 0;
  int at_edges = 0;
};
[[nodiscard]] PredictedOrders predicted_orders(int reproduced_degree, int triangle_precision,
                                               int parallelogram_precision);
[[nodiscard]] PredictedOrders predicted_orders(const BasisFacts& facts);

}  // namespace radcert
