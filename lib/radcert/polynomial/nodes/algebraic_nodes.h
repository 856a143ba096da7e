// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/algebraic_number.h"
#include "radcert/polynomial/plane_polynomial.h"

namespace radcert {

/// Nodes on a triangle with algebraic coordinates, and the functions that they are to determine.
/// Maths     nodes q_j by their barycentric coordinates; space: functions f_m of s = x_3, t = x_2
/// Requires  as many nodes as functions; coordinates with the sum 1
/// Result    plain data
struct AlgebraicNodes {
  AlgebraicField field;
  std::vector<std::array<AlgebraicExpression, 3>> nodes;
  std::vector<PlanePolynomial<Rational>> space;

  /// Balls about the coordinates, at the current precision.
  [[nodiscard]] std::vector<Barycentric<Ball>> values() const;
};

/// The monomials s^a t^b of degree r at most: the space of all polynomials.
[[nodiscard]] std::vector<PlanePolynomial<Rational>> monomials(int degree);

/// Everything about algebraic nodes.
/// Maths     see BasisFacts; a rule with the weights w_j = Int l_j misses a functional L(g) = Int_sigma q g
///           in p by
///               D = sum_j L(l_j) p(q_j) - L(p),  det (f_m(q_j)) D = +- det [f_m(q_j), p(q_j); L(f_m), L(p)],
///           and a weight is a quotient of such determinants. Their heights are at most
///               log (n + 1)! + sum of the heights of the rows,
///           as |det|_v <= (n + 1)! prod_j max(1, |a_j1|_v, ...) and without the factorial for v that primes
///           give; row j is at most that of the coefficients, log of the number of terms, and deg max(1,
///           |s_j|, |t_j|). By Liouville's inequality a ball that holds 0 and is that small proves D = 0
/// Source    AlgebraicField
/// Requires  rounded: the Lagrange functions of the same space at nodes beside the algebraic ones; tolerance
///           > 0, else ContractViolation
/// Result    proof: algebraic. Degrees of precision and of products are decided exactly, and so are the signs
///           of the weights; norm and condition are enclosures for the algebraic nodes, see at_true_nodes;
///           coordinates and weights are rounded
/// Limits    a reason in place of facts where more than `most_bits` would be needed, or where the algebraic
///           nodes are not certainly unisolvent
[[nodiscard]] Outcome<BasisFacts> basis_facts(const LagrangeFunctions& rounded, const AlgebraicNodes& nodes,
                                              const Rational& tolerance,
                                              long most_bits = AlgebraicField::usual_bits);

}  // namespace radcert
