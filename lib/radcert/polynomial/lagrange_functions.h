// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A space of polynomials on a triangle, by functions that span it.
/// Maths     span of f_m = sum_k s_km B_k, |k| = D, with the Bernstein polynomials B_k(x) = D!/(k_1! k_2!
///           k_3!) x^k
/// Requires  (D + 1)(D + 2)/2 coefficients for each function
/// Result    functions: s_km, a list for each m, k in the order of lattice_indices(degree)
struct PolynomialSpace {
  int degree = 0;
  std::vector<std::vector<Rational>> functions;
};

/// Why nodes determine no interpolating polynomial, with the proof.
/// Maths     a polynomial p != 0 of degree r with p(q_j) = 0 at every node:  p = sum_k c_k B_k, B_k =
///           r!/(k_1! k_2! k_3!) x^k; in a space of one's own p = sum_m a_m f_m, not all a_m zero
/// Requires  made by lagrange_functions
/// Result    repeated: two places with the same point, if there are; vanishing: c_k, k in the order of
///           lattice_indices; combination: the a_m, empty for the space of all polynomials. vanishing is 0
///           where the f_m are linearly dependent
/// Limits    which of the vanishing polynomials it is, is not said
struct NotUnisolvent {
  std::optional<std::pair<std::size_t, std::size_t>> repeated;
  std::vector<Rational> vanishing;
  std::vector<Rational> combination = {};
  /// "nodes 1 and 4 are the same point", "a polynomial of degree 2 other than zero vanishes at all 6 nodes:
  /// ...".
  [[nodiscard]] std::string to_text() const;
};

/// The Lagrange functions of a node set on a triangle, exactly.
/// Maths     l_j in P_r or in another space of polynomials of degree r, l_j(q_i) = delta_ij;  l_j = sum_k
///           c_kj B_k, with the Bernstein polynomials B_k(x) = r!/(k_1! k_2! k_3!) x_1^k_1 x_2^k_2 x_3^k_3,
///           |k| = r.  P_r: (c_kj) = (B_k(q_j))^-1
/// Requires  made by lagrange_functions
/// Result    everything exact; the places of k are those of lattice_indices(degree)
/// Limits    for proofs and tables. The pipeline evaluates InsetBasis
class LagrangeFunctions {
public:
  /// r, of the functions.
  [[nodiscard]] int degree() const { return degree_; }
  /// The largest d for which all polynomials of degree d are in the space: r for P_r; -1 where the constants
  /// are not.
  [[nodiscard]] int reproduced_degree() const { return reproduced_degree_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const std::vector<Barycentric<Rational>>& nodes() const { return nodes_; }
  /// det (B_k(q_j)), or det (f_m(q_j)), rows by node: its sign depends on the order of the nodes, whether it
  /// is zero does not depend on the basis.
  [[nodiscard]] const Rational& determinant() const { return determinant_; }
  /// c_kj for all k.
  [[nodiscard]] std::span<const Rational> bernstein_coefficients(std::size_t j) const;
  /// l_j(x) for all j; `out` has size() places. x is a point of the plane: x_1 + x_2 + x_3 = 1.
  void values(const Barycentric<Rational>& x, std::span<Rational> out) const;

private:
  friend Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(
      std::span<const Barycentric<Rational>> nodes);
  friend Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(
      const PolynomialSpace& space, std::span<const Barycentric<Rational>> nodes);
  LagrangeFunctions() = default;

  int degree_ = 0;
  int reproduced_degree_ = 0;
  std::vector<Barycentric<Rational>> nodes_;
  Rational determinant_;
  std::vector<Rational> coefficients_;  ///< polynomial_dimension(degree) for each j in turn
};

/// Whether a polynomial of degree r is determined by its values at the nodes, and if so by which functions.
/// Maths     unisolvent <=> det (B_k(q_j)) != 0
/// Requires  (r + 1)(r + 2)/2 nodes for some r >= 0, the coordinates of each with the sum 1, else
///           ContractViolation
/// Result    exact. A unisolvent set: its Lagrange functions; any other: a polynomial that shows that it is
///           none
/// Limits    time grows like the sixth power of r or faster, and with the length of the coordinates; nodes
///           may lie outside the triangle
[[nodiscard]] Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(
    std::span<const Barycentric<Rational>> nodes);

/// The same for a space of one's own: enriched, as linear functions with a bubble, or incomplete.
/// Maths     unisolvent <=> det (f_m(q_j)) != 0;  l_j = sum_m a_mj f_m, (a_mj) = (f_m(q_j))^-1
/// Requires  as many nodes as functions, one at least, the coordinates of each with the sum 1, else
///           ContractViolation
/// Result    exact. A unisolvent set: its Lagrange functions; any other: a function of the space that shows
///           that it is none
/// Limits    as above
[[nodiscard]] Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(
    const PolynomialSpace& space, std::span<const Barycentric<Rational>> nodes);

}  // namespace radcert
